! main_case: S1002 on UIC60, 80 kN, the source paper's two creepage cases, from Fortran.
! Exits with an error when a call fails or a result leaves the range the paper's case must have.
program main_case
  use wrc
  implicit none
  type(wrc_config) :: config
  type(wrc_planar_pose) :: pose
  type(wrc_planar_point) :: point
  type(wrc_planar_load) :: load
  type(wrc_creepage) :: creepage
  type(wrc_friction) :: friction
  type(wrc_planar_normal_solution) :: normal
  type(wrc_planar_forces) :: forces
  type(wrc_damage) :: damage
  type(c_ptr) :: model, contact
  character(256) :: text
  integer :: i
  integer(c_int32_t) :: known
  real(c_double), parameter :: creepages(3, 2) = reshape([0d0, 0d0, -0.5d0, -0.49d-3, -0.22d-3, 0.29d0], [3, 2])
  real(c_double), parameter :: contact_power(2) = [68.68d0, 30.60d0]  ! CONTACT [W]

  call wrc_init(config)
  call wrc_init(pose)
  call wrc_init(load)
  call wrc_init(creepage)
  call wrc_init(friction, known)
  if (known /= WRC_OK) error stop 'the library is older than the module'
  ! The last member of each group read right means that the layouts agree.
  if (config%track%rail_inclination /= 0d0 .or. config%track%gauge_depth /= 0.014d0 .or. &
      config%planar%gap_rows /= 256) error stop 'layout'
  if (creepage%speed /= 1d0) error stop 'layout'

  config%wheel%kind = WRC_PROFILE_S1002
  config%rail%kind = WRC_PROFILE_UIC60_BENCHMARK
  if (wrc_config_check(config, text) < 0) then
    print '(2a)', 'configuration: ', trim(text)
    error stop 1
  end if
  call check(wrc_model_create(config, c_null_ptr, model))
  call check(wrc_contact_create(model, WRC_SIDE_RIGHT, c_null_ptr, contact))

  load%normal_force = 80d3
  friction%coefficient = 0.35d0
  call check(wrc_planar_geometry(contact, pose, point))
  call check(wrc_planar_normal(contact, c_null_ptr, load, normal))
  print '(a,f5.2,a,f6.2,a,f6.3,a,f7.1,a,f6.2,a)', 'patch: a =', 1d3*normal%ellipse%a, ' mm, b =', 1d3*normal%ellipse%b, &
    ' mm, psi =', normal%ellipse%psi, ', p_max =', 1d-6*normal%peak_pressure, ' MPa, approach =', 1d6*normal%approach, ' um'
  do i = 1, 2
    creepage%longitudinal = creepages(1, i)
    creepage%lateral = creepages(2, i)
    creepage%spin = creepages(3, i)
    call check(wrc_planar_tangential(contact, c_null_ptr, creepage, friction, forces))
    call check(wrc_contact_damage(contact, damage))
    print '(a,i0,a,f8.0,a,f8.0,a,f7.1,a,f7.2,a,f5.1,a)', 'case ', i, ': Fx =', forces%fx, ' N, Fy =', forces%fy, &
      ' N, Mz =', forces%mz, ' N m, power =', forces%power, ' W (', 100*(forces%power/contact_power(i) - 1), &
      ' % from CONTACT)'
    if (abs(forces%power/contact_power(i) - 1) > 0.1d0) error stop 'power is off'
    if (abs(damage%power - forces%power) > 1d-9*forces%power) error stop 'damage and forces disagree'
  end do

  ! a mistake, and what the library says of it
  load%normal_force = 80d0
  if (wrc_planar_normal(contact, c_null_ptr, load, normal) /= WRC_ERROR_RANGE) error stop 'kN was not noticed'
  call wrc_contact_last_error(contact, text)
  print '(2a)', '80 N: ', trim(text)

  call wrc_contact_destroy(contact)
  call wrc_model_destroy(model)

contains

  subroutine check(status)
    integer(c_int32_t), intent(in) :: status
    if (status >= 0) return
    call wrc_contact_last_error(contact, text)
    print '(a,i0,2a)', 'status ', status, ': ', trim(text)
    error stop 1
  end subroutine

end program main_case
