! Optional arguments (module wrc_optional) against the calls with c_null_ptr (module wrc): the same results.
program optional_case
  use wrc
  use wrc_optional
  implicit none
  type(wrc_config) :: config
  type(wrc_planar_input) :: input
  type(wrc_planar_output) :: output
  type(wrc_planar_normal_solution) :: normal, normal_again
  type(wrc_planar_forces) :: forces, forces_again
  type(wrc_wear) :: wear
  type(wrc_wheel_input) :: wheel
  type(wrc_wrench) :: wrench, wrench_again
  type(wrc_wrench_derivatives) :: slopes
  type(c_ptr) :: model, contact
  character(kind=c_char, len=1) :: text(200)

  call wrc_init(config)
  config%wheel%kind = WRC_PROFILE_S1002
  config%rail%kind = WRC_PROFILE_UIC60_BENCHMARK
  if (config_check(config, text, size(text, kind=c_int64_t)) /= WRC_OK) error stop 'configuration'
  if (model_create(config, model=model, size=0_c_int64_t) /= WRC_OK) error stop 'model'
  if (contact_create(model, WRC_SIDE_RIGHT, contact=contact, size=0_c_int64_t) /= WRC_OK) error stop 'contact'

  call wrc_init(input)
  input%load%normal_force = 80d3
  input%creepage%longitudinal = 0.5d-3
  if (planar_step(contact, input) /= WRC_OK) error stop 'step without output'
  if (planar_step(contact, input, output) /= WRC_OK) error stop 'step'

  ! the stages, each its own way
  if (wrc_planar_geometry(contact, input%pose, output%point) /= WRC_OK) error stop 'geometry'
  if (wrc_planar_normal(contact, c_null_ptr, input%load, normal) /= WRC_OK) error stop 'normal'
  if (planar_geometry(contact, input%pose) /= WRC_OK) error stop 'geometry again'
  if (planar_normal(contact, load=input%load, normal=normal_again) /= WRC_OK) error stop 'normal again'
  if (normal%peak_pressure /= normal_again%peak_pressure .or. normal%peak_pressure < 8d8) error stop 'other pressure'
  if (wrc_planar_tangential(contact, c_null_ptr, input%creepage, input%friction, forces) /= WRC_OK) error stop 'tangential'
  if (planar_tangential(contact, creepage=input%creepage, friction=input%friction, forces=forces_again) /= WRC_OK) &
    error stop 'again'
  if (forces%fx /= forces_again%fx .or. forces%fx >= 0d0) error stop 'other force'
  if (contact_wear(contact, 0, wear=wear) /= WRC_OK) error stop 'wear by the published laws'
  if (wear%worn_area_rate <= 0d0) error stop 'no wear'

  call wrc_init(wheel)
  wheel%wheel%z = 0.3d-3
  wheel%wheel%velocity(1) = 20d0
  wheel%wheel%pitch_rate = -20d0/0.46d0
  if (contact_wrench(contact, wheel, wrench) /= WRC_OK) error stop 'wrench'
  if (contact_wrench_derivatives(contact, wheel, derivatives=slopes) /= WRC_OK) error stop 'derivatives alone'
  if (contact_wrench_derivatives(contact, wheel, wrench_again) /= WRC_OK) error stop 'wrench without derivatives'
  if (wrench%force(3) /= wrench_again%force(3) .or. slopes%wrench(2, 3) >= 0d0) error stop 'other wrench'
  print '(a,f10.1,a)', 'force downwards on the wheel ', wrench%force(3), ' N'
  call wrc_contact_destroy(contact)
  call wrc_model_destroy(model)
end program optional_case
