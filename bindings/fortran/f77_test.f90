! f77_test: the plain arrays of wrc_f77.f90 have the bits of the structs they stand for.
program f77_test
  use wrc
  implicit none
  external :: wrcmod, wrccon, wrcwhl, wrcstp, wrctxt, wrcdel, wrcmde
  integer(c_int64_t) :: model, contac
  integer :: istat
  call wrcmod(WRC_PROFILE_S1002, WRC_PROFILE_60E1, 0.025d0, model, istat)
  if (istat < 0) error stop 'model'
  call wrccon(model, WRC_SIDE_LEFT, contac, istat)
  if (istat < 0) error stop 'contact'
  call test_wheel(WRC_PRESCRIBE_HEIGHT)
  call test_wheel(WRC_PRESCRIBE_VERTICAL_LOAD)
  call test_members_refused()
  call test_step()
  call wrcdel(contac)
  call wrcmde(model)

contains

  ! Every input that this model reads has a value of its own.
  subroutine test_wheel(prescribed)
    integer(c_int32_t), intent(in) :: prescribed
    type(wrc_wheel_input) :: input
    type(wrc_wrench) :: wrench
    real(c_double) :: xin(30), xout(18)
    call wrc_init(input)
    input%prescribed = prescribed
    input%wheel%reference = WRC_REFERENCE_WHEEL
    input%wheel%y = 1.1d-3
    input%wheel%z = 0.31d-3
    input%wheel%roll = 0.4d-3
    input%wheel%yaw = 1.7d-3
    input%wheel%velocity = [20d0, -0.03d0, 0.011d0]
    input%wheel%roll_rate = 0.02d0
    input%wheel%pitch_rate = -43.5d0
    input%wheel%yaw_rate = 0.05d0
    input%rail%y = 0.3d-3
    input%rail%z = -0.02d-3
    input%rail%roll = 0.6d-3
    input%rail%y_velocity = 0.007d0
    input%rail%z_velocity = -0.004d0
    input%rail%roll_rate = 0.09d0
    input%rail%y_slope = 0.8d-3
    input%rail%z_slope = -0.3d-3
    input%friction%coefficient = 0.33d0
    input%frame%speed = 0.2d0
    input%frame%curvature = 3d-3
    input%frame%vertical_curvature = 2d-3
    input%frame%twist = 1d-3
    xin = [1d0, 1.1d-3, 0.31d-3, 0.4d-3, 1.7d-3, 20d0, -0.03d0, 0.011d0, 0.02d0, -43.5d0, 0.05d0, 0.3d-3, &
      -0.02d-3, 0.6d-3, 0.007d0, -0.004d0, 0.09d0, 0.33d0, real(prescribed, c_double), 0d0, 0d0, 0d0, 0d0, 0d0, &
      0.2d0, 3d-3, 2d-3, 1d-3, 0.8d-3, -0.3d-3]
    if (prescribed == WRC_PRESCRIBE_HEIGHT) then
      input%damping = 0.15d0
      xin(21) = 0.15d0
    else
      input%vertical_load = 71d3
      xin(20) = 71d3
    end if
    if (wrc_contact_wrench(transfer(contac, c_null_ptr), input, wrench) /= WRC_OK) error stop 'wrench'
    call wrcwhl(contac, xin, xout, istat)
    if (istat /= WRC_OK) error stop 'wrcwhl'
    if (any(xout /= [wrench%force, wrench%moment, wrench%rail_force, wrench%rail_moment, wrench%z, &
      wrench%normal_force, wrench%area, wrench%peak_pressure, wrench%power, real(wrench%region_count, c_double)])) &
      error stop 'wrcwhl differs from wrc_contact_wrench'
    if (.not. (xout(3) < -1d4 .and. xout(17) > 0d0)) error stop 'nothing carries'
  end subroutine

  ! What this model does not read is refused by name; what is no enumerator, too; results are zero then.
  subroutine test_members_refused()
    integer, parameter :: place(6) = [1, 19, 20, 22, 23, 24]
    character(*), parameter :: names(6) = &
      [character(22) :: 'input.wheel.reference', 'input.prescribed', 'input.vertical_load', 'input.distance', 'input.angle', &
       'input.roller_rate']
    real(c_double) :: xin(30), xout(18)
    character(256) :: text
    integer :: i
    do i = 1, size(place)
      xin = 0d0
      xin(6) = 20d0
      xin(place(i)) = 0.5d0
      call wrcwhl(contac, xin, xout, istat)
      if (istat >= 0) error stop 'taken'
      if (any(xout /= 0d0)) error stop 'results of a failure are not zero'
      call wrctxt(contac, text)
      if (index(text, trim(names(i))) == 0) then
        print '(3a)', trim(names(i)), ': ', trim(text)
        error stop 'another member is refused'
      end if
    end do
  end subroutine

  subroutine test_step()
    type(wrc_planar_input) :: input
    type(wrc_planar_output) :: output
    real(c_double) :: xout(12)
    call wrc_init(input)
    input%pose%lateral = 1.1d-3
    input%pose%roll = 0.4d-3
    input%pose%yaw = 1.7d-3
    input%load%normal_force = 71d3
    input%creepage%longitudinal = 0.3d-3
    input%creepage%lateral = -0.2d-3
    input%creepage%spin = 0.15d0
    input%friction%coefficient = 0.33d0
    if (wrc_planar_step(transfer(contac, c_null_ptr), input, output) /= WRC_OK) error stop 'step'
    call wrcstp(contac, [1.1d-3, 0.4d-3, 1.7d-3, 71d3, 0.3d-3, -0.2d-3, 0.15d0, 0.33d0], xout, istat)
    if (istat /= WRC_OK) error stop 'wrcstp'
    if (any(xout /= [output%forces%fx, output%forces%fy, output%forces%fn, output%forces%mz, output%forces%power, &
      output%normal%approach, output%normal%peak_pressure, output%normal%area, output%normal%ellipse%a, &
      output%normal%ellipse%b, output%normal%ellipse%psi, output%damage%fatigue_index])) &
      error stop 'wrcstp differs from wrc_planar_step'
  end subroutine

end program f77_test
