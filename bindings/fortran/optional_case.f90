! Optional arguments (module wrc_optional): what is left out changes nothing else, and the stages one by one have the step's results.
program optional_case
  use wrc_optional
  implicit none
  type(wrc_config) :: config
  type(wrc_planar_input) :: input
  type(wrc_planar_output) :: output
  type(wrc_planar_normal_solution) :: normal
  type(wrc_planar_forces) :: forces
  type(wrc_wear) :: wear
  type(wrc_wheel_input) :: wheel
  type(wrc_wrench) :: wrench, wrench_again
  type(wrc_wrench_derivatives) :: by, by_again
  type(wrc_region) :: region
  type(c_ptr) :: model, contact
  character(300) :: text
  integer(c_int64_t) :: counts(2)
  real(c_double), allocatable :: pressure(:)

  call wrc_init(config)
  config%wheel%kind = WRC_PROFILE_S1002
  config%rail%kind = WRC_PROFILE_UIC60_BENCHMARK
  if (wrc_model_create(config, model, text) /= WRC_OK) error stop 'model'
  if (wrc_contact_create(model, 2, contact, text) >= 0 .or. index(text, 'side') == 0) error stop 'side 2'
  if (wrc_contact_create(model, WRC_SIDE_RIGHT, contact, text) /= WRC_OK) error stop 'contact'

  ! a wheel on a rail
  call wrc_init(wheel)
  wheel%wheel%z = 0.3d-3
  wheel%wheel%velocity(1) = 20d0
  wheel%wheel%pitch_rate = -20d0/0.46d0
  if (wrc_contact_wrench(contact, wheel, wrench) /= WRC_OK) error stop 'wrench'
  if (wrc_contact_wrench_derivatives(contact, wheel, derivatives=by) /= WRC_OK) error stop 'derivatives alone'
  if (wrc_contact_wrench_derivatives(contact, wheel, wrench_again) /= WRC_OK) error stop 'wrench without derivatives'
  if (wrench%force(3) /= wrench_again%force(3) .or. wrench%flags /= 0) error stop 'other wrench'
  if (wrc_contact_wrench_derivatives(contact, wheel, wrench_again, by_again) /= WRC_OK) error stop 'both'
  if (by%wrench(WRC_BY_Z + 1, 3) /= by_again%wrench(WRC_BY_Z + 1, 3) .or. by%wrench(WRC_BY_Z + 1, 3) > -1d8) &
    error stop 'other derivatives'
  print '(a,f10.1,a)', 'force downwards on the wheel ', wrench%force(3), ' N'

  ! its regions, and a field of the first
  if (wrc_contact_region(contact, 0, region) /= WRC_OK) error stop 'region'
  if (wrc_contact_wear(contact, 0, wear=wear) /= WRC_OK) error stop 'wear by the published laws'
  if (wear%worn_area_rate <= 0d0) error stop 'no wear'
  if (wrc_contact_field(contact, 0, WRC_FIELD_PRESSURE, room=0_c_int64_t, counts=counts) /= WRC_OK) error stop 'counts'
  if (any(counts /= [region%cell_count, region%strip_count])) error stop 'other counts'
  allocate(pressure(product(counts)))
  if (wrc_contact_field(contact, 0, WRC_FIELD_PRESSURE, pressure, size(pressure, kind=c_int64_t)) /= WRC_OK) error stop 'field'
  if (maxval(pressure) > region%peak_pressure .or. maxval(pressure) < 0.9d0*region%peak_pressure) error stop 'pressure'

  ! the planar step, and its stages
  call wrc_init(input)
  input%load%normal_force = 80d3
  input%creepage%longitudinal = 0.5d-3
  if (wrc_planar_step(contact, input) /= WRC_OK) error stop 'step without output'
  if (wrc_planar_step(contact, input, output) /= WRC_OK) error stop 'step'
  if (wrc_planar_geometry(contact, input%pose) /= WRC_OK) error stop 'geometry'
  if (wrc_planar_normal(contact, load=input%load, normal=normal) /= WRC_OK) error stop 'normal'
  if (normal%peak_pressure /= output%normal%peak_pressure .or. normal%peak_pressure < 8d8) error stop 'other pressure'
  if (wrc_planar_tangential(contact, creepage=input%creepage, friction=input%friction, forces=forces) /= WRC_OK) &
    error stop 'tangential'
  if (forces%fx /= output%forces%fx .or. forces%fx >= 0d0) error stop 'other force'
  call wrc_contact_destroy(contact)
  call wrc_model_destroy(model)
end program optional_case
