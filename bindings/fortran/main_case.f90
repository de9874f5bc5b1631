! main_case: a wheelset from Fortran, S1002 on 60E1, 80 kN on each wheel. First the height at which it stands, then the wrench
! on both wheels while it rolls with a yaw of 2 mrad. Then a mistake, and what the library says of it.
! Exits with an error when a call fails or a result is not what it must be.
program main_case
  use wrc
  implicit none
  type(wrc_config) :: config
  type(wrc_wheel_input) :: input
  type(wrc_wrench) :: wrench
  type(c_ptr) :: model, contact(0:1)  ! of WRC_SIDE_RIGHT, WRC_SIDE_LEFT
  character(300) :: text
  character(5), parameter :: names(0:1) = ['right', 'left ']
  real(c_double) :: force(3), moment(3)
  integer(c_int32_t) :: side, known
  real(c_double), parameter :: speed = 20d0  ! m/s

  call wrc_init(config)
  call wrc_init(input, known)
  if (known /= WRC_OK) error stop 'the library is older than the module'
  ! The last member of each group read right means that the layouts agree.
  if (config%track%gauge_depth /= 0.014d0 .or. config%planar%gap_limit /= 1d-3 .or. &
      input%friction%slope_reduction /= 1d0) error stop 'layout'

  config%wheel%kind = WRC_PROFILE_S1002
  config%rail%kind = WRC_PROFILE_60E1
  config%track%rail_inclination = 1d0/40d0
  call made(wrc_model_create(config, model, text))
  do side = 0, 1
    call made(wrc_contact_create(model, side, contact(side), text))
  end do

  ! the height at which the wheelset stands, at rest
  input%prescribed = WRC_PRESCRIBE_VERTICAL_LOAD
  input%vertical_load = 80d3
  call solve(WRC_SIDE_RIGHT)
  print '(a,f6.1,a)', 'stands ', 1d6*wrench%z, ' um below its nominal height'

  ! pose and motion of its middle, as a multibody code hands them over in every evaluation
  input%prescribed = WRC_PRESCRIBE_HEIGHT
  input%vertical_load = 0
  input%wheel%z = wrench%z
  input%wheel%yaw = 2d-3
  input%wheel%velocity(1) = speed
  input%wheel%pitch_rate = -speed/config%wheelset%wheel_radius  ! about the axle
  force = 0
  moment = 0
  do side = 0, 1
    call solve(side)
    print '(2a,3(f8.0,a),f6.0,a)', names(side), '  Fx', wrench%force(1), ' N, Fy', wrench%force(2), ' N, Fz', wrench%force(3), &
      ' N, frictional power', wrench%power, ' W'
    force = force + wrench%force
    moment = moment + wrench%moment
  end do
  print '(a,4(f8.0,a))', 'both   Fx', force(1), ' N, Fy', force(2), ' N, Fz', force(3), ' N, moment about z', moment(3), ' N m'
  ! turned to the right it is pushed to the right, and its power is the work that goes in
  if (force(2) < 0 .or. abs(force(3) + 160d3) > 16d3) error stop 'forces'

  ! a mistake, and what the library says of it
  input%prescribed = WRC_PRESCRIBE_VERTICAL_LOAD
  input%vertical_load = 80d0
  if (wrc_contact_wrench(contact(0), input, wrench) /= WRC_ERROR_RANGE) error stop 'kN was not noticed'
  call wrc_contact_last_error(contact(0), text)
  print '(2a)', '80 N: ', trim(text)

  do side = 0, 1
    call wrc_contact_destroy(contact(side))
  end do
  call wrc_model_destroy(model)

contains

  subroutine made(status)
    integer(c_int32_t), intent(in) :: status
    if (status >= 0) return
    print '(a)', trim(text)
    error stop 1
  end subroutine

  subroutine solve(which)
    integer(c_int32_t), intent(in) :: which
    integer(c_int32_t) :: status
    status = wrc_contact_wrench(contact(which), input, wrench)
    if (status >= 0) return
    call wrc_contact_last_error(contact(which), text)
    print '(a,i0,2a)', 'status ', status, ': ', trim(text)
    error stop 1
  end subroutine

end program main_case
