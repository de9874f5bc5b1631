! wrc: wheel/rail contact, Fortran 2003 interface to the C library (include_c/wrc/wrc.h has the documentation).
!
! Types have the names and members of the C structs. Every type must have its init called before use:
!     type(wrc_load) :: load
!     call wrc_init(load)              ! sets struct_size and the defaults
! Handles are type(c_ptr). Members of C enums are integer parameters below.
module wrc
  use, intrinsic :: iso_c_binding
  implicit none
  public

  include 'wrc_status.inc'

  integer(c_int32_t), parameter :: WRC_ABI_VERSION = 1
  integer(c_int32_t), parameter :: WRC_SIDE_RIGHT = 0, WRC_SIDE_LEFT = 1
  integer(c_int32_t), parameter :: WRC_PROFILE_POINTS = 0, WRC_PROFILE_S1002 = 1, WRC_PROFILE_60E1 = 2, &
                                   WRC_PROFILE_UIC60_BENCHMARK = 3
  integer(c_int32_t), parameter :: WRC_NORMAL_HERTZ = 0, WRC_NORMAL_KIK_PIOTROWSKI = 1, WRC_NORMAL_EKP = 2, &
                                   WRC_NORMAL_EKP_ELLIPSE = 3, WRC_NORMAL_ANALYN = 4, WRC_NORMAL_STRIPES = 5, &
                                   WRC_NORMAL_STRIP_HALFSPACE = 6
  integer(c_int32_t), parameter :: WRC_REGULARISE_KEEP_WIDTH = 0, WRC_REGULARISE_KEEP_RATIO = 1
  integer(c_int32_t), parameter :: WRC_TANGENTIAL_FASTSIM = 0, WRC_TANGENTIAL_FASTSIM_EQE = 1, &
                                   WRC_TANGENTIAL_FASTSIM_EQL = 2, WRC_TANGENTIAL_FASTSIM_SDEC = 3, &
                                   WRC_TANGENTIAL_STRIP_FASTSIM = 4
  integer(c_int32_t), parameter :: WRC_BOUND_PARABOLIC = 0, WRC_BOUND_ELLIPTIC = 1
  integer(c_int32_t), parameter :: WRC_PRESCRIBE_LOAD = 0, WRC_PRESCRIBE_APPROACH = 1

  type, bind(C) :: wrc_profile
    integer(c_int32_t) :: struct_size, kind, count, reserved
    type(c_ptr) :: y, z
    real(c_double) :: smoothing
  end type

  type, bind(C) :: wrc_config
    integer(c_int32_t) :: struct_size, side, normal_method, regularisation, tangential_method, traction_bound
    integer(c_int32_t) :: strips, cells, gap_rows, max_iterations, max_patches, warm_start
    real(c_double) :: shear_modulus, poisson, load_tolerance, gap_limit, shear_yield, wheel_radius
    real(c_double) :: flange_back_distance, track_gauge, gauge_depth, rail_inclination
    type(c_ptr) :: wheel, rail
    integer(c_int32_t) :: flexibility, instruction_set
    type(c_ptr) :: force_table
  end type

  type, bind(C) :: wrc_pose
    integer(c_int32_t) :: struct_size, reserved
    real(c_double) :: lateral, roll, yaw
  end type

  type, bind(C) :: wrc_contact_point
    integer(c_int32_t) :: struct_size, reserved
    real(c_double) :: x, y, z, y_wheel, y_rail, angle, vertical_gap, rolling_radius
  end type

  type, bind(C) :: wrc_load
    integer(c_int32_t) :: struct_size, prescribed
    real(c_double) :: normal_force, approach
  end type

  type, bind(C) :: wrc_creepage
    integer(c_int32_t) :: struct_size, reserved
    real(c_double) :: longitudinal, lateral, spin, speed
  end type

  type, bind(C) :: wrc_friction
    integer(c_int32_t) :: struct_size, reserved
    real(c_double) :: coefficient
  end type

  type, bind(C) :: wrc_patch
    integer(c_int32_t) :: struct_size, strips, iterations, patches
    real(c_double) :: a, b, psi, normal_force, approach, stiffness, peak_pressure, area, length, width, y_min, y_max
  end type

  type, bind(C) :: wrc_forces
    integer(c_int32_t) :: struct_size, reserved
    real(c_double) :: fx, fy, fn, mz, power, adhesion_fraction
  end type

  type, bind(C) :: wrc_damage
    integer(c_int32_t) :: struct_size, reserved
    real(c_double) :: power, peak_power_density, t_gamma, t_gamma_no_spin, utilisation, load_factor
    real(c_double) :: shakedown_limit, fatigue_index, local_fatigue_index
  end type

  type, bind(C) :: wrc_wear_laws
    integer(c_int32_t) :: struct_size, reserved
    real(c_double) :: t_gamma_mild_end, t_gamma_severe_start, t_gamma_mild_slope, t_gamma_plateau
    real(c_double) :: t_gamma_severe_slope, t_gamma_severe_offset, sheffield_mild_end, sheffield_severe_end
    real(c_double) :: sheffield_mild_slope, sheffield_catastrophic_slope, density, hardness
    real(c_double) :: archard_slow, archard_severe, archard_fast, archard_seizure
    real(c_double) :: archard_severe_start, archard_severe_end, seizure_pressure
  end type

  type, bind(C) :: wrc_wear
    integer(c_int32_t) :: struct_size, reserved
    real(c_double) :: worn_area_rate, largest_depth_rate, largest_depth_velocity
  end type

  ! forces(input, force): inputs longitudinal, lateral, spin, normal force, friction; forces fx, fy, mz
  type, bind(C) :: wrc_sensitivity
    integer(c_int32_t) :: struct_size, reserved
    real(c_double) :: forces(5, 3)
  end type

  type, bind(C) :: wrc_step_sensitivity
    integer(c_int32_t) :: struct_size, reserved
    real(c_double) :: by_load(4), by_lateral(4)
  end type

  interface
    function wrc_version() bind(C) result(version)
      import
      integer(c_int32_t) :: version
    end function
    function wrc_model_create(config, allocator, model) bind(C) result(status)
      import
      type(wrc_config), intent(in) :: config
      type(c_ptr), value :: allocator
      type(c_ptr), intent(out) :: model
      integer(c_int32_t) :: status
    end function
    subroutine wrc_model_destroy(model) bind(C)
      import
      type(c_ptr), value :: model
    end subroutine
    function wrc_contact_create(model, allocator, contact) bind(C) result(status)
      import
      type(c_ptr), value :: model, allocator
      type(c_ptr), intent(out) :: contact
      integer(c_int32_t) :: status
    end function
    subroutine wrc_contact_destroy(contact) bind(C)
      import
      type(c_ptr), value :: contact
    end subroutine
    function wrc_geometry(contact, pose, point) bind(C) result(status)
      import
      type(c_ptr), value :: contact
      type(wrc_pose), intent(in) :: pose
      type(wrc_contact_point), intent(inout) :: point
      integer(c_int32_t) :: status
    end function
    ! gap: c_null_ptr for the gap of the last wrc_geometry
    function wrc_normal(contact, gap, load, patch) bind(C) result(status)
      import
      type(c_ptr), value :: contact, gap
      type(wrc_load), intent(in) :: load
      type(wrc_patch), intent(inout) :: patch
      integer(c_int32_t) :: status
    end function
    ! patch: c_null_ptr for the patch of the last wrc_normal, or c_loc of a wrc_patch
    function wrc_tangential(contact, patch, creepage, friction, forces) bind(C) result(status)
      import
      type(c_ptr), value :: contact, patch
      type(wrc_creepage), intent(in) :: creepage
      type(wrc_friction), intent(in) :: friction
      type(wrc_forces), intent(inout) :: forces
      integer(c_int32_t) :: status
    end function
    function wrc_wear_laws_init(laws) bind(C) result(status)
      import
      type(wrc_wear_laws), intent(inout) :: laws
      integer(c_int32_t) :: status
    end function
    ! laws: c_null_ptr for the published ones, or c_loc of a wrc_wear_laws
    function wrc_wear_numbers(contact, laws, wear) bind(C) result(status)
      import
      type(c_ptr), value :: contact, laws
      type(wrc_wear), intent(inout) :: wear
      integer(c_int32_t) :: status
    end function
    function wrc_sensitivities(contact, sensitivity) bind(C) result(status)
      import
      type(c_ptr), value :: contact
      type(wrc_sensitivity), intent(inout) :: sensitivity
      integer(c_int32_t) :: status
    end function
    function wrc_step_sensitivities(contact, sensitivity) bind(C) result(status)
      import
      type(c_ptr), value :: contact
      type(wrc_step_sensitivity), intent(inout) :: sensitivity
      integer(c_int32_t) :: status
    end function
    function wrc_damage_numbers(contact, damage) bind(C) result(status)
      import
      type(c_ptr), value :: contact
      type(wrc_damage), intent(inout) :: damage
      integer(c_int32_t) :: status
    end function
    ! Fortran 77 style: in(8) and out(12) as documented at wrc_step_flat in wrc.h
    function wrc_step_flat(contact, in, out) bind(C) result(status)
      import
      type(c_ptr), value :: contact
      real(c_double), intent(in) :: in(8)
      real(c_double), intent(out) :: out(12)
      integer(c_int32_t) :: status
    end function
    function wrc_config_check_c(config, text, size) bind(C, name='wrc_config_check') result(status)
      import
      type(wrc_config), intent(in) :: config
      character(kind=c_char), intent(out) :: text(*)
      integer(c_int64_t), value :: size
      integer(c_int32_t) :: status
    end function
    function wrc_last_error_c(contact, text, size) bind(C, name='wrc_last_error') result(status)
      import
      type(c_ptr), value :: contact
      character(kind=c_char), intent(out) :: text(*)
      integer(c_int64_t), value :: size
      integer(c_int32_t) :: status
    end function
    function wrc_profile_init(profile) bind(C) result(status)
      import
      type(wrc_profile), intent(inout) :: profile
      integer(c_int32_t) :: status
    end function
    function wrc_config_init(config) bind(C) result(status)
      import
      type(wrc_config), intent(inout) :: config
      integer(c_int32_t) :: status
    end function
    function wrc_pose_init(pose) bind(C) result(status)
      import
      type(wrc_pose), intent(inout) :: pose
      integer(c_int32_t) :: status
    end function
    function wrc_contact_point_init(point) bind(C) result(status)
      import
      type(wrc_contact_point), intent(inout) :: point
      integer(c_int32_t) :: status
    end function
    function wrc_load_init(load) bind(C) result(status)
      import
      type(wrc_load), intent(inout) :: load
      integer(c_int32_t) :: status
    end function
    function wrc_creepage_init(creepage) bind(C) result(status)
      import
      type(wrc_creepage), intent(inout) :: creepage
      integer(c_int32_t) :: status
    end function
    function wrc_friction_init(friction) bind(C) result(status)
      import
      type(wrc_friction), intent(inout) :: friction
      integer(c_int32_t) :: status
    end function
    function wrc_patch_init(patch) bind(C) result(status)
      import
      type(wrc_patch), intent(inout) :: patch
      integer(c_int32_t) :: status
    end function
    function wrc_forces_init(forces) bind(C) result(status)
      import
      type(wrc_forces), intent(inout) :: forces
      integer(c_int32_t) :: status
    end function
    function wrc_damage_init(damage) bind(C) result(status)
      import
      type(wrc_damage), intent(inout) :: damage
      integer(c_int32_t) :: status
    end function
  end interface

  ! Sets struct_size and the defaults of any wrc type. Stops if the library knows the struct by another size: the
  ! module and the library are then of different versions.
  interface wrc_init
    module procedure init_profile, init_config, init_pose, init_contact_point, init_load, init_creepage, &
                     init_friction, init_patch, init_forces, init_damage
  end interface

contains

  subroutine init_profile(profile)
    type(wrc_profile), intent(out) :: profile
    profile%struct_size = int(c_sizeof(profile), c_int32_t)
    call expect_ok(wrc_profile_init(profile), 'wrc_profile')
  end subroutine
  subroutine init_config(config)
    type(wrc_config), intent(out) :: config
    config%struct_size = int(c_sizeof(config), c_int32_t)
    call expect_ok(wrc_config_init(config), 'wrc_config')
  end subroutine
  subroutine init_pose(pose)
    type(wrc_pose), intent(out) :: pose
    pose%struct_size = int(c_sizeof(pose), c_int32_t)
    call expect_ok(wrc_pose_init(pose), 'wrc_pose')
  end subroutine
  subroutine init_contact_point(point)
    type(wrc_contact_point), intent(out) :: point
    point%struct_size = int(c_sizeof(point), c_int32_t)
    call expect_ok(wrc_contact_point_init(point), 'wrc_contact_point')
  end subroutine
  subroutine init_load(load)
    type(wrc_load), intent(out) :: load
    load%struct_size = int(c_sizeof(load), c_int32_t)
    call expect_ok(wrc_load_init(load), 'wrc_load')
  end subroutine
  subroutine init_creepage(creepage)
    type(wrc_creepage), intent(out) :: creepage
    creepage%struct_size = int(c_sizeof(creepage), c_int32_t)
    call expect_ok(wrc_creepage_init(creepage), 'wrc_creepage')
  end subroutine
  subroutine init_friction(friction)
    type(wrc_friction), intent(out) :: friction
    friction%struct_size = int(c_sizeof(friction), c_int32_t)
    call expect_ok(wrc_friction_init(friction), 'wrc_friction')
  end subroutine
  subroutine init_patch(patch)
    type(wrc_patch), intent(out) :: patch
    patch%struct_size = int(c_sizeof(patch), c_int32_t)
    call expect_ok(wrc_patch_init(patch), 'wrc_patch')
  end subroutine
  subroutine init_forces(forces)
    type(wrc_forces), intent(out) :: forces
    forces%struct_size = int(c_sizeof(forces), c_int32_t)
    call expect_ok(wrc_forces_init(forces), 'wrc_forces')
  end subroutine
  subroutine init_damage(damage)
    type(wrc_damage), intent(out) :: damage
    damage%struct_size = int(c_sizeof(damage), c_int32_t)
    call expect_ok(wrc_damage_init(damage), 'wrc_damage')
  end subroutine

  subroutine expect_ok(status, name)
    integer(c_int32_t), intent(in) :: status
    character(*), intent(in) :: name
    if (status /= WRC_OK) then
      print '(3a)', 'wrc: the library knows type ', name, ' by another size: module and library differ in version'
      stop 1
    end if
  end subroutine

  ! Says whether a model can be made of `config`, and if not why.
  function wrc_config_check(config, text) result(status)
    type(wrc_config), intent(in) :: config
    character(*), intent(out) :: text
    integer(c_int32_t) :: status
    character(kind=c_char) :: buffer(256)
    status = wrc_config_check_c(config, buffer, size(buffer, kind=c_int64_t))
    call from_c(buffer, text)
  end function

  ! The sentence behind the last status other than WRC_OK on this contact.
  subroutine wrc_last_error(contact, text)
    type(c_ptr), intent(in) :: contact
    character(*), intent(out) :: text
    character(kind=c_char) :: buffer(256)
    integer(c_int32_t) :: status
    status = wrc_last_error_c(contact, buffer, size(buffer, kind=c_int64_t))
    call from_c(buffer, text)
    if (status /= WRC_OK) text = 'no contact'
  end subroutine

  subroutine from_c(buffer, text)
    character(kind=c_char), intent(in) :: buffer(:)
    character(*), intent(out) :: text
    integer :: i
    text = ''
    do i = 1, min(size(buffer), len(text))
      if (buffer(i) == c_null_char) exit
      text(i:i) = buffer(i)
    end do
  end subroutine

end module wrc
