! First tries of a wheel's motion: the right force, or a sentence. S1002 on 60E1 at 1:40, 80 kN, 20 m/s, nose 5 mrad to the
! right, friction 0.35.
program wheel_case
  use wrc
  implicit none
  real(c_double), parameter :: yaw = 5d-3, rolling = -20d0/0.46d0
  type(wrc_config) :: config
  type(wrc_wheel_input) :: input
  type(wrc_wrench) :: wrench
  type(c_ptr) :: model, contact
  real(c_double) :: R(3, 3)
  character(256) :: text

  call wrc_init(config)
  config%wheel%kind = WRC_PROFILE_S1002
  config%rail%kind = WRC_PROFILE_60E1
  config%track%rail_inclination = 1d0/40d0
  if (wrc_model_create(config, model, text) /= WRC_OK) error stop 'model'
  if (wrc_contact_create(model, WRC_SIDE_RIGHT, contact, text) /= WRC_OK) error stop 'contact'

  ! rates, the axle by its angles
  call begin()
  input%wheel%yaw = yaw
  input%wheel%pitch_rate = rolling
  call expect('pitch_rate', WRC_OK)
  print '(a,f9.1,a,f8.1,a)', 'lateral force ', wrench%force(2), ' N, power ', wrench%power, ' W'

  ! a vector of no axes
  call begin()
  input%wheel%yaw = yaw
  input%wheel%angular_velocity(2) = rolling
  call expect('a vector of no axes', WRC_ERROR_RANGE)
  if (index(text, 'WRC_AXES_TRACK') == 0 .or. index(text, 'WRC_AXES_BODY') == 0) error stop 'the sentence says no axes'
  input%wheel%angular_axes = WRC_AXES_BODY
  call expect('along the axle', WRC_OK)

  ! a matrix of Fortran, track = matmul(R, body)
  R = reshape([cos(yaw), sin(yaw), 0d0, -sin(yaw), cos(yaw), 0d0, 0d0, 0d0, 1d0], [3, 3])
  call begin()
  input%wheel%pitch_rate = rolling
  input%wheel%rotation = reshape(R, [9])
  call expect('a matrix without its order', WRC_ERROR_RANGE)
  if (index(text, 'WRC_ORIENTATION_COLUMNS') == 0) error stop 'the sentence says no order'
  call wrc_set_rotation(input%wheel, R)
  call expect('a matrix', WRC_OK)
  input%wheel%yaw = yaw
  call expect('a matrix and angles', WRC_ERROR_RANGE)

  ! its transpose is noticed by the angular velocity in track axes
  call begin()
  input%wheel%angular_axes = WRC_AXES_TRACK
  input%wheel%angular_velocity = matmul(R, [0d0, rolling, 0d0])
  call wrc_set_rotation(input%wheel, R)
  call expect('a matrix and a vector', WRC_OK)
  call wrc_set_rotation(input%wheel, transpose(R))
  call expect('the transpose', WRC_FLAG_ROTATION_TRANSPOSED)

  ! a rail at rest, 1 mrad aslant: no lateral creepage
  call begin()
  input%wheel%pitch_rate = rolling
  input%rail%y_slope = 1d-3
  call solve()
  if (abs(wrench%force(2)) > 500d0) error stop 'a rail aslant pushes aside'
  call wrc_contact_destroy(contact)
  call wrc_model_destroy(model)

contains

  subroutine begin()
    call wrc_init(input)
    input%prescribed = WRC_PRESCRIBE_VERTICAL_LOAD
    input%vertical_load = 80d3
    input%friction%coefficient = 0.35d0
    input%wheel%velocity(1) = 20d0
  end subroutine

  subroutine solve()
    if (wrc_contact_wrench(contact, input, wrench) /= WRC_OK) error stop 'wrench'
  end subroutine

  ! With WRC_OK the force must be that of a wheel that turns about its own axle.
  subroutine expect(what, status)
    character(*), intent(in) :: what
    integer(c_int32_t), intent(in) :: status
    if (wrc_contact_wrench(contact, input, wrench) /= status) error stop what
    call wrc_contact_last_error(contact, text)
    if (status /= WRC_OK) return
    if (abs(wrench%force(2) - 24.84d3) > 10d0 .or. abs(wrench%power - 2779d0) > 1d0) error stop what
  end subroutine

end program wheel_case
