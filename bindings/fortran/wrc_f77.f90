! Subroutines for Fortran 77: names of six letters, plain arguments, handles in INTEGER*8. Compile it with module wrc.
!     CALL WRCMOD(IWHEEL, IRAIL, CANT, MODEL, ISTAT)   a model: enum wrc_profile_kind, tangent of the rails' cant
!     CALL WRCPTS(IWHEEL, NW, YW, ZW, IRAIL, NR, YR, ZR, SMOOTH, CANT, MODEL, TEXT, ISTAT)
!                                                      the same with points YW, ZW [m] where IWHEEL is 1, YR, ZR where
!                                                      IRAIL is 1; SMOOTH as wrc_profile.smoothing [m]; a sentence in
!                                                      TEXT where ISTAT < 0
!     CALL WRCCON(MODEL, ISIDE, CONTAC, ISTAT)         a contact of side 0 (right) or 1 (left)
!     CALL WRCWHL(CONTAC, XIN, XOUT, ISTAT)            wrc_contact_wrench: 30 numbers in, 18 out
!     CALL WRCSTP(CONTAC, XIN, XOUT, ISTAT)            wrc_planar_step: 8 numbers in, 12 out
!     CALL WRCTXT(CONTAC, TEXT)                        the sentence behind the last status
!     CALL WRCDEL(CONTAC)                              releases a contact
!     CALL WRCMDE(MODEL)                               releases a model, its contacts before
! ISTAT is a status of wrc_status.h: 0 done, > 0 flagged, < 0 failed; then MODEL or CONTAC is 0, XOUT is zero.
!
! XIN of WRCWHL     1       reference point: 0 middle of the axle, 1 wheel
!                   2, 3    y, z of that point [m]
!                   4, 5    roll, yaw [rad]
!                   6 - 8   velocity x, y, z [m/s]
!                   9 - 11  roll rate, pitch rate about the axle (-v/r0 rolling forwards), yaw rate [rad/s]
!                   12 - 14 rail: y, z [m], roll [rad]
!                   15 - 17 rail: their rates [m/s, rad/s]; of a bent rail at rest 0
!                   18      coefficient of friction, 0: none
!                   19, 20  1: the vertical load [N] is given and z is found; 0: z is given
!                   21      damping [s/m]
!                   22, 23  distance along the track [m], angle about the axle [rad]
!                   24      angular velocity of a roller [rad/s]
!                   25 - 28 frame: speed [m/s], curvature, vertical curvature, twist [1/m]
!                   29, 30  rail: slopes dy/dx, dz/dx
! XOUT of WRCWHL    1 - 3   force on the wheel x, y, z [N]
!                   4 - 6   moment on the wheel x, y, z [N m]
!                   7 - 9   force on the rail x, y, z [N]
!                   10 - 12 moment on the rail x, y, z [N m]
!                   13      z of the reference point [m]
!                   14      normal force [N]
!                   15, 16  area [m^2], peak pressure [Pa]
!                   17, 18  frictional power [W], number of regions
!
! XIN of WRCSTP     lateral [m], roll, yaw [rad], normal force [N], creepages longitudinal, lateral [-], spin [1/m],
!                   coefficient of friction
! XOUT of WRCSTP    fx, fy, fn [N], mz [N m], frictional power / speed [N], approach [m], peak pressure [Pa],
!                   area [m^2], a, b [m], psi, fatigue index
subroutine wrcmod(iwheel, irail, cant, model, istat)
  use wrc
  implicit none
  integer, intent(in) :: iwheel, irail
  real(c_double), intent(in) :: cant
  integer(c_int64_t), intent(out) :: model
  integer, intent(out) :: istat
  double precision :: none(1)
  character(1) :: text
  none = 0d0
  call wrcpts(iwheel, 0, none, none, irail, 0, none, none, 0d0, cant, model, text, istat)
end subroutine

subroutine wrcpts(iwheel, nw, yw, zw, irail, nr, yr, zr, smooth, cant, model, text, istat)
  use wrc
  implicit none
  integer, intent(in) :: iwheel, nw, irail, nr
  real(c_double), intent(in) :: yw(*), zw(*), yr(*), zr(*), smooth, cant
  integer(c_int64_t), intent(out) :: model
  character(*), intent(out) :: text
  integer, intent(out) :: istat
  type(wrc_config) :: config
  type(c_ptr) :: made
  real(c_double), allocatable, target :: wheel(:,:), rail(:,:)
  call wrc_init(config)
  call describe(config%wheel, iwheel, nw, yw, zw, wheel)
  call describe(config%rail, irail, nr, yr, zr, rail)
  config%track%rail_inclination = cant
  istat = wrc_model_create(config, made, text)
  model = transfer(made, model)
contains
  ! A profile of this kind; points, columns y and z, are of the kind WRC_PROFILE_POINTS alone.
  subroutine describe(profile, kind, count, y, z, points)
    type(wrc_profile), intent(inout) :: profile
    integer, intent(in) :: kind, count
    real(c_double), intent(in) :: y(*), z(*)
    real(c_double), allocatable, target, intent(inout) :: points(:,:)
    profile%kind = kind
    if (kind /= WRC_PROFILE_POINTS) return
    allocate(points(max(count, 1), 2))
    points(:count, 1) = y(:count)
    points(:count, 2) = z(:count)
    profile%count = count
    profile%y = c_loc(points(1, 1))
    profile%z = c_loc(points(1, 2))
    profile%smoothing = smooth
  end subroutine
end subroutine

subroutine wrccon(model, iside, contac, istat)
  use wrc
  implicit none
  integer(c_int64_t), intent(in) :: model
  integer, intent(in) :: iside
  integer(c_int64_t), intent(out) :: contac
  integer, intent(out) :: istat
  character(1) :: text
  type(c_ptr) :: made
  istat = wrc_contact_create(transfer(model, c_null_ptr), iside, made, text)
  contac = transfer(made, contac)
end subroutine

subroutine wrcwhl(contac, xin, xout, istat)
  use wrc
  implicit none
  integer(c_int64_t), intent(in) :: contac
  real(c_double), intent(in) :: xin(30)
  real(c_double), intent(out) :: xout(18)
  integer, intent(out) :: istat
  type(wrc_wheel_input) :: input
  type(wrc_wrench) :: wrench
  call wrc_init(input)
  input%wheel%reference = enumerator(xin(1))
  input%wheel%y = xin(2)
  input%wheel%z = xin(3)
  input%wheel%roll = xin(4)
  input%wheel%yaw = xin(5)
  input%wheel%velocity = xin(6:8)
  input%wheel%roll_rate = xin(9)
  input%wheel%pitch_rate = xin(10)
  input%wheel%yaw_rate = xin(11)
  input%rail%y = xin(12)
  input%rail%z = xin(13)
  input%rail%roll = xin(14)
  input%rail%y_velocity = xin(15)
  input%rail%z_velocity = xin(16)
  input%rail%roll_rate = xin(17)
  input%friction%coefficient = xin(18)
  input%prescribed = enumerator(xin(19))
  input%vertical_load = xin(20)
  input%damping = xin(21)
  input%distance = xin(22)
  input%angle = xin(23)
  input%roller_rate = xin(24)
  input%frame%speed = xin(25)
  input%frame%curvature = xin(26)
  input%frame%vertical_curvature = xin(27)
  input%frame%twist = xin(28)
  input%rail%y_slope = xin(29)
  input%rail%z_slope = xin(30)
  istat = wrc_contact_wrench(transfer(contac, c_null_ptr), input, wrench)
  xout = [wrench%force, wrench%moment, wrench%rail_force, wrench%rail_moment, wrench%z, wrench%normal_force, &
    wrench%area, wrench%peak_pressure, wrench%power, real(wrench%region_count, c_double)]
contains
  ! A whole number as it is, any other as -1, which no enumeration has.
  integer(c_int32_t) function enumerator(number)
    real(c_double), intent(in) :: number
    enumerator = -1
    if (abs(number) < 1d9 .and. abs(number - anint(number)) <= 0d0) enumerator = int(number, c_int32_t)
  end function
end subroutine

subroutine wrcstp(contac, xin, xout, istat)
  use wrc
  implicit none
  integer(c_int64_t), intent(in) :: contac
  real(c_double), intent(in) :: xin(8)
  real(c_double), intent(out) :: xout(12)
  integer, intent(out) :: istat
  type(wrc_planar_input) :: input
  type(wrc_planar_output) :: output
  call wrc_init(input)
  input%pose%lateral = xin(1)
  input%pose%roll = xin(2)
  input%pose%yaw = xin(3)
  input%load%normal_force = xin(4)
  input%creepage%longitudinal = xin(5)
  input%creepage%lateral = xin(6)
  input%creepage%spin = xin(7)
  input%friction%coefficient = xin(8)
  istat = wrc_planar_step(transfer(contac, c_null_ptr), input, output)
  xout = [output%forces%fx, output%forces%fy, output%forces%fn, output%forces%mz, output%forces%power, &
    output%normal%approach, output%normal%peak_pressure, output%normal%area, output%normal%ellipse%a, &
    output%normal%ellipse%b, output%normal%ellipse%psi, output%damage%fatigue_index]
end subroutine

subroutine wrctxt(contac, text)
  use wrc
  implicit none
  integer(c_int64_t), intent(in) :: contac
  character(*), intent(out) :: text
  call wrc_contact_last_error(transfer(contac, c_null_ptr), text)
end subroutine

subroutine wrcdel(contac)
  use wrc
  implicit none
  integer(c_int64_t), intent(in) :: contac
  call wrc_contact_destroy(transfer(contac, c_null_ptr))
end subroutine

subroutine wrcmde(model)
  use wrc
  implicit none
  integer(c_int64_t), intent(in) :: model
  call wrc_model_destroy(transfer(model, c_null_ptr))
end subroutine
