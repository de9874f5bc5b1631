! Written by tools/interface/describe.py from the headers in include_c/wrc: do not edit.
module layout
  use, intrinsic :: iso_c_binding
  implicit none
  integer(c_size_t), bind(C) :: layout_wrc_profile(7)
  integer(c_size_t), bind(C) :: layout_wrc_material(5)
  integer(c_size_t), bind(C) :: layout_wrc_heat_properties(5)
  integer(c_size_t), bind(C) :: layout_wrc_config_wheelset(4)
  integer(c_size_t), bind(C) :: layout_wrc_config_track(8)
  integer(c_size_t), bind(C) :: layout_wrc_rail_section(9)
  integer(c_size_t), bind(C) :: layout_wrc_config_roundness(7)
  integer(c_size_t), bind(C) :: layout_wrc_config_check_rail(5)
  integer(c_size_t), bind(C) :: layout_wrc_config_normal(5)
  integer(c_size_t), bind(C) :: layout_wrc_config_tangential(7)
  integer(c_size_t), bind(C) :: layout_wrc_config_surface(9)
  integer(c_size_t), bind(C) :: layout_wrc_config_planar(11)
  integer(c_size_t), bind(C) :: layout_wrc_config(21)
  integer(c_size_t), bind(C) :: layout_wrc_allocator(5)
  integer(c_size_t), bind(C) :: layout_wrc_view(4)
  integer(c_size_t), bind(C) :: layout_wrc_bulk_temperatures(4)
  integer(c_size_t), bind(C) :: layout_wrc_friction(28)
  integer(c_size_t), bind(C) :: layout_wrc_wheel_state(16)
  integer(c_size_t), bind(C) :: layout_wrc_rail_state(10)
  integer(c_size_t), bind(C) :: layout_wrc_frame_motion(6)
  integer(c_size_t), bind(C) :: layout_wrc_wheel_input(15)
  integer(c_size_t), bind(C) :: layout_wrc_wrench(18)
  integer(c_size_t), bind(C) :: layout_wrc_wrench_derivatives(5)
  integer(c_size_t), bind(C) :: layout_wrc_creepage(8)
  integer(c_size_t), bind(C) :: layout_wrc_ellipse(7)
  integer(c_size_t), bind(C) :: layout_wrc_region(31)
  integer(c_size_t), bind(C) :: layout_wrc_damage(13)
  integer(c_size_t), bind(C) :: layout_wrc_planar_pose(5)
  integer(c_size_t), bind(C) :: layout_wrc_planar_motion(8)
  integer(c_size_t), bind(C) :: layout_wrc_planar_point(10)
  integer(c_size_t), bind(C) :: layout_wrc_planar_gap(11)
  integer(c_size_t), bind(C) :: layout_wrc_planar_load(8)
  integer(c_size_t), bind(C) :: layout_wrc_planar_strips(9)
  integer(c_size_t), bind(C) :: layout_wrc_planar_normal_solution(17)
  integer(c_size_t), bind(C) :: layout_wrc_planar_forces(10)
  integer(c_size_t), bind(C) :: layout_wrc_planar_derivatives(4)
  integer(c_size_t), bind(C) :: layout_wrc_planar_input(8)
  integer(c_size_t), bind(C) :: layout_wrc_planar_output(7)
  integer(c_size_t), bind(C) :: layout_wrc_wear_laws(25)
  integer(c_size_t), bind(C) :: layout_wrc_wear(6)
  integer(c_size_t), bind(C) :: layout_wrc_coefficients(9)
  integer(c_size_t), bind(C) :: layout_wrc_stress_peak(6)
  integer(c_size_t), bind(C) :: layout_wrc_stress_peaks(5)
  integer(c_size_t), bind(C) :: layout_wrc_stresses(6)
  integer(c_size_t), bind(C) :: layout_wrc_temperature(11)
  integer(c_size_t), bind(C) :: layout_wrc_damage_bin(6)
  integer(c_size_t), bind(C) :: layout_wrc_damage_bins(10)
  integer(c_size_t), bind(C) :: layout_wrc_fatigue_laws(7)
  integer(c_size_t), bind(C) :: layout_wrc_accumulation(7)
  integer(c_size_t), bind(C) :: layout_wrc_damage_totals(5)
  integer(c_size_t), bind(C) :: layout_wrc_grid(8)
  integer(c_size_t), bind(C) :: layout_wrc_exact_normal_problem(14)
  integer(c_size_t), bind(C) :: layout_wrc_exact_normal_solution(11)
  integer(c_size_t), bind(C) :: layout_wrc_exact_rolling_problem(19)
  integer(c_size_t), bind(C) :: layout_wrc_exact_rolling_solution(16)
  integer(c_size_t), bind(C) :: layout_wrc_exact_loads(8)
  integer(c_size_t), bind(C) :: layout_wrc_exact_wrench_options(9)
  integer(c_size_t), bind(C) :: layout_wrc_exact_check_options(7)
  integer(c_size_t), bind(C) :: layout_wrc_exact_check_result(10)
  integer(c_size_t), bind(C) :: layout_wrc_creep_curve(15)
  integer(c_size_t), bind(C) :: layout_wrc_creep_fit(14)
  integer(c_size_t), bind(C) :: layout_wrc_wheelset_geometry_problem(5)
  integer(c_size_t), bind(C) :: layout_wrc_wheelset_geometry(14)
  integer(c_size_t), bind(C) :: layout_wrc_conicity_problem(10)
  integer(c_size_t), bind(C) :: layout_wrc_conicity(6)
  integer(c_size_t), bind(C) :: layout_wrc_profile_wear(14)
  integer(c_size_t), bind(C) :: layout_wrc_worn_profile(10)
  integer(c_size_t), bind(C) :: layout_wrc_flange(5)
  integer(c_size_t), bind(C) :: layout_wrc_section_line(7)
  integer(c_size_t), bind(C) :: layout_wrc_rail_faces_problem(14)
  integer(c_size_t), bind(C) :: layout_wrc_found_faces(10)
  integer(c_size_t), bind(C) :: layout_wrc_face_outline(12)
  integer(c_size_t), bind(C) :: layout_wrc_surface_bin(4)
  integer(c_size_t), bind(C) :: layout_wrc_surface(12)
  integer(c_size_t), bind(C) :: layout_wrc_substance(14)
  integer(c_size_t), bind(C) :: layout_wrc_surface_laws(17)
  integer(c_size_t), bind(C) :: layout_wrc_surface_passage(12)
  integer(c_size_t), bind(C) :: layout_wrc_surface_exchange(7)
end module
program layout_test
  use wrc
  use layout
  implicit none
  integer :: failures = 0
  call test_wrc_profile()
  call test_wrc_material()
  call test_wrc_heat_properties()
  call test_wrc_config_wheelset()
  call test_wrc_config_track()
  call test_wrc_rail_section()
  call test_wrc_config_roundness()
  call test_wrc_config_check_rail()
  call test_wrc_config_normal()
  call test_wrc_config_tangential()
  call test_wrc_config_surface()
  call test_wrc_config_planar()
  call test_wrc_config()
  call test_wrc_allocator()
  call test_wrc_view()
  call test_wrc_bulk_temperatures()
  call test_wrc_friction()
  call test_wrc_wheel_state()
  call test_wrc_rail_state()
  call test_wrc_frame_motion()
  call test_wrc_wheel_input()
  call test_wrc_wrench()
  call test_wrc_wrench_derivatives()
  call test_wrc_creepage()
  call test_wrc_ellipse()
  call test_wrc_region()
  call test_wrc_damage()
  call test_wrc_planar_pose()
  call test_wrc_planar_motion()
  call test_wrc_planar_point()
  call test_wrc_planar_gap()
  call test_wrc_planar_load()
  call test_wrc_planar_strips()
  call test_wrc_planar_normal_solution()
  call test_wrc_planar_forces()
  call test_wrc_planar_derivatives()
  call test_wrc_planar_input()
  call test_wrc_planar_output()
  call test_wrc_wear_laws()
  call test_wrc_wear()
  call test_wrc_coefficients()
  call test_wrc_stress_peak()
  call test_wrc_stress_peaks()
  call test_wrc_stresses()
  call test_wrc_temperature()
  call test_wrc_damage_bin()
  call test_wrc_damage_bins()
  call test_wrc_fatigue_laws()
  call test_wrc_accumulation()
  call test_wrc_damage_totals()
  call test_wrc_grid()
  call test_wrc_exact_normal_problem()
  call test_wrc_exact_normal_solution()
  call test_wrc_exact_rolling_problem()
  call test_wrc_exact_rolling_solution()
  call test_wrc_exact_loads()
  call test_wrc_exact_wrench_options()
  call test_wrc_exact_check_options()
  call test_wrc_exact_check_result()
  call test_wrc_creep_curve()
  call test_wrc_creep_fit()
  call test_wrc_wheelset_geometry_problem()
  call test_wrc_wheelset_geometry()
  call test_wrc_conicity_problem()
  call test_wrc_conicity()
  call test_wrc_profile_wear()
  call test_wrc_worn_profile()
  call test_wrc_flange()
  call test_wrc_section_line()
  call test_wrc_rail_faces_problem()
  call test_wrc_found_faces()
  call test_wrc_face_outline()
  call test_wrc_surface_bin()
  call test_wrc_surface()
  call test_wrc_substance()
  call test_wrc_surface_laws()
  call test_wrc_surface_passage()
  call test_wrc_surface_exchange()
  print '(i0,a)', 78, ' types compared'
  if (failures > 0) stop 1
contains
  subroutine test_wrc_profile()
    type(wrc_profile), target :: a
    call wrc_init(a)
    call same('wrc_profile', 'size', c_sizeof(a), layout_wrc_profile(1))
    call same('wrc_profile', 'kind', &
      distance(c_loc(a), c_loc(a%kind)), layout_wrc_profile(2))
    call same('wrc_profile', 'count', &
      distance(c_loc(a), c_loc(a%count)), layout_wrc_profile(3))
    call same('wrc_profile', 'y', &
      distance(c_loc(a), c_loc(a%y)), layout_wrc_profile(4))
    call same('wrc_profile', 'z', &
      distance(c_loc(a), c_loc(a%z)), layout_wrc_profile(5))
    call same('wrc_profile', 'smoothing', &
      distance(c_loc(a), c_loc(a%smoothing)), layout_wrc_profile(6))
    call same('wrc_profile', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_profile(7))
  end subroutine
  subroutine test_wrc_material()
    type(wrc_material), target :: a
    call wrc_init(a)
    call same('wrc_material', 'size', c_sizeof(a), layout_wrc_material(1))
    call same('wrc_material', 'shear_modulus', &
      distance(c_loc(a), c_loc(a%shear_modulus)), layout_wrc_material(2))
    call same('wrc_material', 'poisson', &
      distance(c_loc(a), c_loc(a%poisson)), layout_wrc_material(3))
    call same('wrc_material', 'shear_yield', &
      distance(c_loc(a), c_loc(a%shear_yield)), layout_wrc_material(4))
    call same('wrc_material', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_material(5))
  end subroutine
  subroutine test_wrc_heat_properties()
    type(wrc_heat_properties), target :: a
    call wrc_init(a)
    call same('wrc_heat_properties', 'size', c_sizeof(a), layout_wrc_heat_properties(1))
    call same('wrc_heat_properties', 'conductivity', &
      distance(c_loc(a), c_loc(a%conductivity)), layout_wrc_heat_properties(2))
    call same('wrc_heat_properties', 'density', &
      distance(c_loc(a), c_loc(a%density)), layout_wrc_heat_properties(3))
    call same('wrc_heat_properties', 'specific_heat', &
      distance(c_loc(a), c_loc(a%specific_heat)), layout_wrc_heat_properties(4))
    call same('wrc_heat_properties', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_heat_properties(5))
  end subroutine
  subroutine test_wrc_config_wheelset()
    type(wrc_config_wheelset), target :: a
    call wrc_init(a)
    call same('wrc_config_wheelset', 'size', c_sizeof(a), layout_wrc_config_wheelset(1))
    call same('wrc_config_wheelset', 'wheel_radius', &
      distance(c_loc(a), c_loc(a%wheel_radius)), layout_wrc_config_wheelset(2))
    call same('wrc_config_wheelset', 'tape_circle_distance', &
      distance(c_loc(a), c_loc(a%tape_circle_distance)), layout_wrc_config_wheelset(3))
    call same('wrc_config_wheelset', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_config_wheelset(4))
  end subroutine
  subroutine test_wrc_config_track()
    type(wrc_config_track), target :: a
    call wrc_init(a)
    call same('wrc_config_track', 'size', c_sizeof(a), layout_wrc_config_track(1))
    call same('wrc_config_track', 'placement', &
      distance(c_loc(a), c_loc(a%placement)), layout_wrc_config_track(2))
    call same('wrc_config_track', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_config_track(3))
    call same('wrc_config_track', 'gauge', &
      distance(c_loc(a), c_loc(a%gauge)), layout_wrc_config_track(4))
    call same('wrc_config_track', 'gauge_depth', &
      distance(c_loc(a), c_loc(a%gauge_depth)), layout_wrc_config_track(5))
    call same('wrc_config_track', 'rail_inclination', &
      distance(c_loc(a), c_loc(a%rail_inclination)), layout_wrc_config_track(6))
    call same('wrc_config_track', 'rail_origin', &
      distance(c_loc(a), c_loc(a%rail_origin)), layout_wrc_config_track(7))
    call same('wrc_config_track', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_config_track(8))
  end subroutine
  subroutine test_wrc_rail_section()
    type(wrc_rail_section), target :: a
    call wrc_init(a)
    call same('wrc_rail_section', 'size', c_sizeof(a), layout_wrc_rail_section(1))
    call same('wrc_rail_section', 'distance', &
      distance(c_loc(a), c_loc(a%distance)), layout_wrc_rail_section(2))
    call same('wrc_rail_section', 'y', &
      distance(c_loc(a), c_loc(a%y)), layout_wrc_rail_section(3))
    call same('wrc_rail_section', 'z', &
      distance(c_loc(a), c_loc(a%z)), layout_wrc_rail_section(4))
    call same('wrc_rail_section', 'surface', &
      distance(c_loc(a), c_loc(a%surface)), layout_wrc_rail_section(5))
    call same('wrc_rail_section', 'mark_count', &
      distance(c_loc(a), c_loc(a%mark_count)), layout_wrc_rail_section(6))
    call same('wrc_rail_section', 'marks', &
      distance(c_loc(a), c_loc(a%marks)), layout_wrc_rail_section(7))
    call same('wrc_rail_section', 'profile', &
      distance(c_loc(a), c_loc(a%profile)), layout_wrc_rail_section(8))
    call same('wrc_rail_section', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_rail_section(9))
  end subroutine
  subroutine test_wrc_config_roundness()
    type(wrc_config_roundness), target :: a
    call wrc_init(a)
    call same('wrc_config_roundness', 'size', c_sizeof(a), layout_wrc_config_roundness(1))
    call same('wrc_config_roundness', 'angle_count', &
      distance(c_loc(a), c_loc(a%angle_count)), layout_wrc_config_roundness(2))
    call same('wrc_config_roundness', 'row_count', &
      distance(c_loc(a), c_loc(a%row_count)), layout_wrc_config_roundness(3))
    call same('wrc_config_roundness', 'angles', &
      distance(c_loc(a), c_loc(a%angles)), layout_wrc_config_roundness(4))
    call same('wrc_config_roundness', 'y', &
      distance(c_loc(a), c_loc(a%y)), layout_wrc_config_roundness(5))
    call same('wrc_config_roundness', 'deviations', &
      distance(c_loc(a), c_loc(a%deviations)), layout_wrc_config_roundness(6))
    call same('wrc_config_roundness', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_config_roundness(7))
  end subroutine
  subroutine test_wrc_config_check_rail()
    type(wrc_config_check_rail), target :: a
    call wrc_init(a)
    call same('wrc_config_check_rail', 'size', c_sizeof(a), layout_wrc_config_check_rail(1))
    call same('wrc_config_check_rail', 'y', &
      distance(c_loc(a), c_loc(a%y)), layout_wrc_config_check_rail(2))
    call same('wrc_config_check_rail', 'z', &
      distance(c_loc(a), c_loc(a%z)), layout_wrc_config_check_rail(3))
    call same('wrc_config_check_rail', 'profile', &
      distance(c_loc(a), c_loc(a%profile)), layout_wrc_config_check_rail(4))
    call same('wrc_config_check_rail', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_config_check_rail(5))
  end subroutine
  subroutine test_wrc_config_normal()
    type(wrc_config_normal), target :: a
    call wrc_init(a)
    call same('wrc_config_normal', 'size', c_sizeof(a), layout_wrc_config_normal(1))
    call same('wrc_config_normal', 'method', &
      distance(c_loc(a), c_loc(a%method)), layout_wrc_config_normal(2))
    call same('wrc_config_normal', 'max_iterations', &
      distance(c_loc(a), c_loc(a%max_iterations)), layout_wrc_config_normal(3))
    call same('wrc_config_normal', 'load_tolerance', &
      distance(c_loc(a), c_loc(a%load_tolerance)), layout_wrc_config_normal(4))
    call same('wrc_config_normal', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_config_normal(5))
  end subroutine
  subroutine test_wrc_config_tangential()
    type(wrc_config_tangential), target :: a
    call wrc_init(a)
    call same('wrc_config_tangential', 'size', c_sizeof(a), layout_wrc_config_tangential(1))
    call same('wrc_config_tangential', 'method', &
      distance(c_loc(a), c_loc(a%method)), layout_wrc_config_tangential(2))
    call same('wrc_config_tangential', 'patch_model', &
      distance(c_loc(a), c_loc(a%patch_model)), layout_wrc_config_tangential(3))
    call same('wrc_config_tangential', 'bound', &
      distance(c_loc(a), c_loc(a%bound)), layout_wrc_config_tangential(4))
    call same('wrc_config_tangential', 'flexibility', &
      distance(c_loc(a), c_loc(a%flexibility)), layout_wrc_config_tangential(5))
    call same('wrc_config_tangential', 'force_table', &
      distance(c_loc(a), c_loc(a%force_table)), layout_wrc_config_tangential(6))
    call same('wrc_config_tangential', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_config_tangential(7))
  end subroutine
  subroutine test_wrc_config_surface()
    type(wrc_config_surface), target :: a
    call wrc_init(a)
    call same('wrc_config_surface', 'size', c_sizeof(a), layout_wrc_config_surface(1))
    call same('wrc_config_surface', 'cells', &
      distance(c_loc(a), c_loc(a%cells)), layout_wrc_config_surface(2))
    call same('wrc_config_surface', 'memory', &
      distance(c_loc(a), c_loc(a%memory)), layout_wrc_config_surface(3))
    call same('wrc_config_surface', 'tread_width', &
      distance(c_loc(a), c_loc(a%tread_width)), layout_wrc_config_surface(4))
    call same('wrc_config_surface', 'corner_width', &
      distance(c_loc(a), c_loc(a%corner_width)), layout_wrc_config_surface(5))
    call same('wrc_config_surface', 'tolerance', &
      distance(c_loc(a), c_loc(a%tolerance)), layout_wrc_config_surface(6))
    call same('wrc_config_surface', 'max_work', &
      distance(c_loc(a), c_loc(a%max_work)), layout_wrc_config_surface(7))
    call same('wrc_config_surface', 'max_iterations', &
      distance(c_loc(a), c_loc(a%max_iterations)), layout_wrc_config_surface(8))
    call same('wrc_config_surface', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_config_surface(9))
  end subroutine
  subroutine test_wrc_config_planar()
    type(wrc_config_planar), target :: a
    call wrc_init(a)
    call same('wrc_config_planar', 'size', c_sizeof(a), layout_wrc_config_planar(1))
    call same('wrc_config_planar', 'strips', &
      distance(c_loc(a), c_loc(a%strips)), layout_wrc_config_planar(2))
    call same('wrc_config_planar', 'cells', &
      distance(c_loc(a), c_loc(a%cells)), layout_wrc_config_planar(3))
    call same('wrc_config_planar', 'gap_rows', &
      distance(c_loc(a), c_loc(a%gap_rows)), layout_wrc_config_planar(4))
    call same('wrc_config_planar', 'max_patches', &
      distance(c_loc(a), c_loc(a%max_patches)), layout_wrc_config_planar(5))
    call same('wrc_config_planar', 'max_sweeps', &
      distance(c_loc(a), c_loc(a%max_sweeps)), layout_wrc_config_planar(6))
    call same('wrc_config_planar', 'start', &
      distance(c_loc(a), c_loc(a%start)), layout_wrc_config_planar(7))
    call same('wrc_config_planar', 'regularisation', &
      distance(c_loc(a), c_loc(a%regularisation)), layout_wrc_config_planar(8))
    call same('wrc_config_planar', 'non_steady', &
      distance(c_loc(a), c_loc(a%non_steady)), layout_wrc_config_planar(9))
    call same('wrc_config_planar', 'gap_limit', &
      distance(c_loc(a), c_loc(a%gap_limit)), layout_wrc_config_planar(10))
    call same('wrc_config_planar', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_config_planar(11))
  end subroutine
  subroutine test_wrc_config()
    type(wrc_config), target :: a
    call same('wrc_config', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_config', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_config', 'size', c_sizeof(a), layout_wrc_config(1))
    call same('wrc_config', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_config(2))
    call same('wrc_config', 'instruction_set', &
      distance(c_loc(a), c_loc(a%instruction_set)), layout_wrc_config(3))
    call same('wrc_config', 'wheel', &
      distance(c_loc(a), c_loc(a%wheel)), layout_wrc_config(4))
    call same('wrc_config', 'rail', &
      distance(c_loc(a), c_loc(a%rail)), layout_wrc_config(5))
    call same('wrc_config', 'wheel_material', &
      distance(c_loc(a), c_loc(a%wheel_material)), layout_wrc_config(6))
    call same('wrc_config', 'rail_material', &
      distance(c_loc(a), c_loc(a%rail_material)), layout_wrc_config(7))
    call same('wrc_config', 'wheel_heat', &
      distance(c_loc(a), c_loc(a%wheel_heat)), layout_wrc_config(8))
    call same('wrc_config', 'rail_heat', &
      distance(c_loc(a), c_loc(a%rail_heat)), layout_wrc_config(9))
    call same('wrc_config', 'wheelset', &
      distance(c_loc(a), c_loc(a%wheelset)), layout_wrc_config(10))
    call same('wrc_config', 'track', &
      distance(c_loc(a), c_loc(a%track)), layout_wrc_config(11))
    call same('wrc_config', 'normal', &
      distance(c_loc(a), c_loc(a%normal)), layout_wrc_config(12))
    call same('wrc_config', 'tangential', &
      distance(c_loc(a), c_loc(a%tangential)), layout_wrc_config(13))
    call same('wrc_config', 'surface', &
      distance(c_loc(a), c_loc(a%surface)), layout_wrc_config(14))
    call same('wrc_config', 'planar', &
      distance(c_loc(a), c_loc(a%planar)), layout_wrc_config(15))
    call same('wrc_config', 'roundness', &
      distance(c_loc(a), c_loc(a%roundness)), layout_wrc_config(16))
    call same('wrc_config', 'roller_curvature', &
      distance(c_loc(a), c_loc(a%roller_curvature)), layout_wrc_config(17))
    call same('wrc_config', 'check_rail', &
      distance(c_loc(a), c_loc(a%check_rail)), layout_wrc_config(18))
    call same('wrc_config', 'rail_section_count', &
      distance(c_loc(a), c_loc(a%rail_section_count)), layout_wrc_config(19))
    call same('wrc_config', 'rail_section_size', &
      distance(c_loc(a), c_loc(a%rail_section_size)), layout_wrc_config(20))
    call same('wrc_config', 'rail_sections', &
      distance(c_loc(a), c_loc(a%rail_sections)), layout_wrc_config(21))
  end subroutine
  subroutine test_wrc_allocator()
    type(wrc_allocator), target :: a
    call wrc_init(a)
    call same('wrc_allocator', 'size', c_sizeof(a), layout_wrc_allocator(1))
    call same('wrc_allocator', 'user', &
      distance(c_loc(a), c_loc(a%user)), layout_wrc_allocator(2))
    call same('wrc_allocator', 'allocate', &
      distance(c_loc(a), c_loc(a%allocate)), layout_wrc_allocator(3))
    call same('wrc_allocator', 'release', &
      distance(c_loc(a), c_loc(a%release)), layout_wrc_allocator(4))
    call same('wrc_allocator', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_allocator(5))
  end subroutine
  subroutine test_wrc_view()
    type(wrc_view), target :: a
    call wrc_init(a)
    call same('wrc_view', 'size', c_sizeof(a), layout_wrc_view(1))
    call same('wrc_view', 'data', &
      distance(c_loc(a), c_loc(a%data)), layout_wrc_view(2))
    call same('wrc_view', 'count', &
      distance(c_loc(a), c_loc(a%count)), layout_wrc_view(3))
    call same('wrc_view', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_view(4))
  end subroutine
  subroutine test_wrc_bulk_temperatures()
    type(wrc_bulk_temperatures), target :: a
    call wrc_init(a)
    call same('wrc_bulk_temperatures', 'size', c_sizeof(a), layout_wrc_bulk_temperatures(1))
    call same('wrc_bulk_temperatures', 'wheel', &
      distance(c_loc(a), c_loc(a%wheel)), layout_wrc_bulk_temperatures(2))
    call same('wrc_bulk_temperatures', 'rail', &
      distance(c_loc(a), c_loc(a%rail)), layout_wrc_bulk_temperatures(3))
    call same('wrc_bulk_temperatures', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_bulk_temperatures(4))
  end subroutine
  subroutine test_wrc_friction()
    type(wrc_friction), target :: a
    call wrc_init(a)
    call same('wrc_friction', 'size', c_sizeof(a), layout_wrc_friction(1))
    call same('wrc_friction', 'coefficient', &
      distance(c_loc(a), c_loc(a%coefficient)), layout_wrc_friction(2))
    call same('wrc_friction', 'speed_law', &
      distance(c_loc(a), c_loc(a%speed_law)), layout_wrc_friction(3))
    call same('wrc_friction', 'temperature_law', &
      distance(c_loc(a), c_loc(a%temperature_law)), layout_wrc_friction(4))
    call same('wrc_friction', 'kinetic_ratio', &
      distance(c_loc(a), c_loc(a%kinetic_ratio)), layout_wrc_friction(5))
    call same('wrc_friction', 'fall_rate', &
      distance(c_loc(a), c_loc(a%fall_rate)), layout_wrc_friction(6))
    call same('wrc_friction', 'half_speed', &
      distance(c_loc(a), c_loc(a%half_speed)), layout_wrc_friction(7))
    call same('wrc_friction', 'hot_ratio', &
      distance(c_loc(a), c_loc(a%hot_ratio)), layout_wrc_friction(8))
    call same('wrc_friction', 'cold_temperature', &
      distance(c_loc(a), c_loc(a%cold_temperature)), layout_wrc_friction(9))
    call same('wrc_friction', 'hot_temperature', &
      distance(c_loc(a), c_loc(a%hot_temperature)), layout_wrc_friction(10))
    call same('wrc_friction', 'bulk', &
      distance(c_loc(a), c_loc(a%bulk)), layout_wrc_friction(11))
    call same('wrc_friction', 'slope_reduction', &
      distance(c_loc(a), c_loc(a%slope_reduction)), layout_wrc_friction(12))
    call same('wrc_friction', 'slope_limit', &
      distance(c_loc(a), c_loc(a%slope_limit)), layout_wrc_friction(13))
    call same('wrc_friction', 'slope_fall', &
      distance(c_loc(a), c_loc(a%slope_fall)), layout_wrc_friction(14))
    call same('wrc_friction', 'zone_y', &
      distance(c_loc(a), c_loc(a%zone_y)), layout_wrc_friction(15))
    call same('wrc_friction', 'zone_coefficients', &
      distance(c_loc(a), c_loc(a%zone_coefficients)), layout_wrc_friction(16))
    call same('wrc_friction', 'zone_count', &
      distance(c_loc(a), c_loc(a%zone_count)), layout_wrc_friction(17))
    call same('wrc_friction', 'zone_frame', &
      distance(c_loc(a), c_loc(a%zone_frame)), layout_wrc_friction(18))
    call same('wrc_friction', 'layer_thickness', &
      distance(c_loc(a), c_loc(a%layer_thickness)), layout_wrc_friction(19))
    call same('wrc_friction', 'layer_modulus', &
      distance(c_loc(a), c_loc(a%layer_modulus)), layout_wrc_friction(20))
    call same('wrc_friction', 'layer_yield', &
      distance(c_loc(a), c_loc(a%layer_yield)), layout_wrc_friction(21))
    call same('wrc_friction', 'layer_hardening', &
      distance(c_loc(a), c_loc(a%layer_hardening)), layout_wrc_friction(22))
    call same('wrc_friction', 'adhesion_reduction', &
      distance(c_loc(a), c_loc(a%adhesion_reduction)), layout_wrc_friction(23))
    call same('wrc_friction', 'slip_reduction', &
      distance(c_loc(a), c_loc(a%slip_reduction)), layout_wrc_friction(24))
    call same('wrc_friction', 'film_rows', &
      distance(c_loc(a), c_loc(a%film_rows)), layout_wrc_friction(25))
    call same('wrc_friction', 'film_numbers', &
      distance(c_loc(a), c_loc(a%film_numbers)), layout_wrc_friction(26))
    call same('wrc_friction', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_friction(27))
    call same('wrc_friction', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_friction(28))
  end subroutine
  subroutine test_wrc_wheel_state()
    type(wrc_wheel_state), target :: a
    call wrc_init(a)
    call same('wrc_wheel_state', 'size', c_sizeof(a), layout_wrc_wheel_state(1))
    call same('wrc_wheel_state', 'reference', &
      distance(c_loc(a), c_loc(a%reference)), layout_wrc_wheel_state(2))
    call same('wrc_wheel_state', 'orientation', &
      distance(c_loc(a), c_loc(a%orientation)), layout_wrc_wheel_state(3))
    call same('wrc_wheel_state', 'angular_axes', &
      distance(c_loc(a), c_loc(a%angular_axes)), layout_wrc_wheel_state(4))
    call same('wrc_wheel_state', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_wheel_state(5))
    call same('wrc_wheel_state', 'y', &
      distance(c_loc(a), c_loc(a%y)), layout_wrc_wheel_state(6))
    call same('wrc_wheel_state', 'z', &
      distance(c_loc(a), c_loc(a%z)), layout_wrc_wheel_state(7))
    call same('wrc_wheel_state', 'roll', &
      distance(c_loc(a), c_loc(a%roll)), layout_wrc_wheel_state(8))
    call same('wrc_wheel_state', 'yaw', &
      distance(c_loc(a), c_loc(a%yaw)), layout_wrc_wheel_state(9))
    call same('wrc_wheel_state', 'velocity', &
      distance(c_loc(a), c_loc(a%velocity)), layout_wrc_wheel_state(10))
    call same('wrc_wheel_state', 'roll_rate', &
      distance(c_loc(a), c_loc(a%roll_rate)), layout_wrc_wheel_state(11))
    call same('wrc_wheel_state', 'pitch_rate', &
      distance(c_loc(a), c_loc(a%pitch_rate)), layout_wrc_wheel_state(12))
    call same('wrc_wheel_state', 'yaw_rate', &
      distance(c_loc(a), c_loc(a%yaw_rate)), layout_wrc_wheel_state(13))
    call same('wrc_wheel_state', 'angular_velocity', &
      distance(c_loc(a), c_loc(a%angular_velocity)), layout_wrc_wheel_state(14))
    call same('wrc_wheel_state', 'rotation', &
      distance(c_loc(a), c_loc(a%rotation)), layout_wrc_wheel_state(15))
    call same('wrc_wheel_state', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_wheel_state(16))
  end subroutine
  subroutine test_wrc_rail_state()
    type(wrc_rail_state), target :: a
    call wrc_init(a)
    call same('wrc_rail_state', 'size', c_sizeof(a), layout_wrc_rail_state(1))
    call same('wrc_rail_state', 'y', &
      distance(c_loc(a), c_loc(a%y)), layout_wrc_rail_state(2))
    call same('wrc_rail_state', 'z', &
      distance(c_loc(a), c_loc(a%z)), layout_wrc_rail_state(3))
    call same('wrc_rail_state', 'roll', &
      distance(c_loc(a), c_loc(a%roll)), layout_wrc_rail_state(4))
    call same('wrc_rail_state', 'y_slope', &
      distance(c_loc(a), c_loc(a%y_slope)), layout_wrc_rail_state(5))
    call same('wrc_rail_state', 'z_slope', &
      distance(c_loc(a), c_loc(a%z_slope)), layout_wrc_rail_state(6))
    call same('wrc_rail_state', 'y_velocity', &
      distance(c_loc(a), c_loc(a%y_velocity)), layout_wrc_rail_state(7))
    call same('wrc_rail_state', 'z_velocity', &
      distance(c_loc(a), c_loc(a%z_velocity)), layout_wrc_rail_state(8))
    call same('wrc_rail_state', 'roll_rate', &
      distance(c_loc(a), c_loc(a%roll_rate)), layout_wrc_rail_state(9))
    call same('wrc_rail_state', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_rail_state(10))
  end subroutine
  subroutine test_wrc_frame_motion()
    type(wrc_frame_motion), target :: a
    call wrc_init(a)
    call same('wrc_frame_motion', 'size', c_sizeof(a), layout_wrc_frame_motion(1))
    call same('wrc_frame_motion', 'speed', &
      distance(c_loc(a), c_loc(a%speed)), layout_wrc_frame_motion(2))
    call same('wrc_frame_motion', 'curvature', &
      distance(c_loc(a), c_loc(a%curvature)), layout_wrc_frame_motion(3))
    call same('wrc_frame_motion', 'vertical_curvature', &
      distance(c_loc(a), c_loc(a%vertical_curvature)), layout_wrc_frame_motion(4))
    call same('wrc_frame_motion', 'twist', &
      distance(c_loc(a), c_loc(a%twist)), layout_wrc_frame_motion(5))
    call same('wrc_frame_motion', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_frame_motion(6))
  end subroutine
  subroutine test_wrc_wheel_input()
    type(wrc_wheel_input), target :: a
    call same('wrc_wheel_input', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_wheel_input', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_wheel_input', 'size', c_sizeof(a), layout_wrc_wheel_input(1))
    call same('wrc_wheel_input', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_wheel_input(2))
    call same('wrc_wheel_input', 'prescribed', &
      distance(c_loc(a), c_loc(a%prescribed)), layout_wrc_wheel_input(3))
    call same('wrc_wheel_input', 'start', &
      distance(c_loc(a), c_loc(a%start)), layout_wrc_wheel_input(4))
    call same('wrc_wheel_input', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_wheel_input(5))
    call same('wrc_wheel_input', 'wheel', &
      distance(c_loc(a), c_loc(a%wheel)), layout_wrc_wheel_input(6))
    call same('wrc_wheel_input', 'rail', &
      distance(c_loc(a), c_loc(a%rail)), layout_wrc_wheel_input(7))
    call same('wrc_wheel_input', 'frame', &
      distance(c_loc(a), c_loc(a%frame)), layout_wrc_wheel_input(8))
    call same('wrc_wheel_input', 'friction', &
      distance(c_loc(a), c_loc(a%friction)), layout_wrc_wheel_input(9))
    call same('wrc_wheel_input', 'vertical_load', &
      distance(c_loc(a), c_loc(a%vertical_load)), layout_wrc_wheel_input(10))
    call same('wrc_wheel_input', 'damping', &
      distance(c_loc(a), c_loc(a%damping)), layout_wrc_wheel_input(11))
    call same('wrc_wheel_input', 'distance', &
      distance(c_loc(a), c_loc(a%distance)), layout_wrc_wheel_input(12))
    call same('wrc_wheel_input', 'angle', &
      distance(c_loc(a), c_loc(a%angle)), layout_wrc_wheel_input(13))
    call same('wrc_wheel_input', 'roller_rate', &
      distance(c_loc(a), c_loc(a%roller_rate)), layout_wrc_wheel_input(14))
    call same('wrc_wheel_input', 'time_step', &
      distance(c_loc(a), c_loc(a%time_step)), layout_wrc_wheel_input(15))
  end subroutine
  subroutine test_wrc_wrench()
    type(wrc_wrench), target :: a
    call same('wrc_wrench', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_wrench', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_wrench', 'size', c_sizeof(a), layout_wrc_wrench(1))
    call same('wrc_wrench', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_wrench(2))
    call same('wrc_wrench', 'flags', &
      distance(c_loc(a), c_loc(a%flags)), layout_wrc_wrench(3))
    call same('wrc_wrench', 'region_count', &
      distance(c_loc(a), c_loc(a%region_count)), layout_wrc_wrench(4))
    call same('wrc_wrench', 'iterations', &
      distance(c_loc(a), c_loc(a%iterations)), layout_wrc_wrench(5))
    call same('wrc_wrench', 'force', &
      distance(c_loc(a), c_loc(a%force)), layout_wrc_wrench(6))
    call same('wrc_wrench', 'moment', &
      distance(c_loc(a), c_loc(a%moment)), layout_wrc_wrench(7))
    call same('wrc_wrench', 'rail_force', &
      distance(c_loc(a), c_loc(a%rail_force)), layout_wrc_wrench(8))
    call same('wrc_wrench', 'rail_moment', &
      distance(c_loc(a), c_loc(a%rail_moment)), layout_wrc_wrench(9))
    call same('wrc_wrench', 'z', &
      distance(c_loc(a), c_loc(a%z)), layout_wrc_wrench(10))
    call same('wrc_wrench', 'clearance', &
      distance(c_loc(a), c_loc(a%clearance)), layout_wrc_wrench(11))
    call same('wrc_wrench', 'normal_force', &
      distance(c_loc(a), c_loc(a%normal_force)), layout_wrc_wrench(12))
    call same('wrc_wrench', 'area', &
      distance(c_loc(a), c_loc(a%area)), layout_wrc_wrench(13))
    call same('wrc_wrench', 'peak_pressure', &
      distance(c_loc(a), c_loc(a%peak_pressure)), layout_wrc_wrench(14))
    call same('wrc_wrench', 'power', &
      distance(c_loc(a), c_loc(a%power)), layout_wrc_wrench(15))
    call same('wrc_wrench', 'steepest_angle', &
      distance(c_loc(a), c_loc(a%steepest_angle)), layout_wrc_wrench(16))
    call same('wrc_wrench', 'residual', &
      distance(c_loc(a), c_loc(a%residual)), layout_wrc_wrench(17))
    call same('wrc_wrench', 'work', &
      distance(c_loc(a), c_loc(a%work)), layout_wrc_wrench(18))
  end subroutine
  subroutine test_wrc_wrench_derivatives()
    type(wrc_wrench_derivatives), target :: a
    call same('wrc_wrench_derivatives', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_wrench_derivatives', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_wrench_derivatives', 'size', c_sizeof(a), layout_wrc_wrench_derivatives(1))
    call same('wrc_wrench_derivatives', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_wrench_derivatives(2))
    call same('wrc_wrench_derivatives', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_wrench_derivatives(3))
    call same('wrc_wrench_derivatives', 'wrench', &
      distance(c_loc(a), c_loc(a%wrench)), layout_wrc_wrench_derivatives(4))
    call same('wrc_wrench_derivatives', 'z', &
      distance(c_loc(a), c_loc(a%z)), layout_wrc_wrench_derivatives(5))
  end subroutine
  subroutine test_wrc_creepage()
    type(wrc_creepage), target :: a
    call wrc_init(a)
    call same('wrc_creepage', 'size', c_sizeof(a), layout_wrc_creepage(1))
    call same('wrc_creepage', 'longitudinal', &
      distance(c_loc(a), c_loc(a%longitudinal)), layout_wrc_creepage(2))
    call same('wrc_creepage', 'lateral', &
      distance(c_loc(a), c_loc(a%lateral)), layout_wrc_creepage(3))
    call same('wrc_creepage', 'spin', &
      distance(c_loc(a), c_loc(a%spin)), layout_wrc_creepage(4))
    call same('wrc_creepage', 'speed', &
      distance(c_loc(a), c_loc(a%speed)), layout_wrc_creepage(5))
    call same('wrc_creepage', 'approach_velocity', &
      distance(c_loc(a), c_loc(a%approach_velocity)), layout_wrc_creepage(6))
    call same('wrc_creepage', 'reverse_share', &
      distance(c_loc(a), c_loc(a%reverse_share)), layout_wrc_creepage(7))
    call same('wrc_creepage', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_creepage(8))
  end subroutine
  subroutine test_wrc_ellipse()
    type(wrc_ellipse), target :: a
    call wrc_init(a)
    call same('wrc_ellipse', 'size', c_sizeof(a), layout_wrc_ellipse(1))
    call same('wrc_ellipse', 'a', &
      distance(c_loc(a), c_loc(a%a)), layout_wrc_ellipse(2))
    call same('wrc_ellipse', 'b', &
      distance(c_loc(a), c_loc(a%b)), layout_wrc_ellipse(3))
    call same('wrc_ellipse', 'psi', &
      distance(c_loc(a), c_loc(a%psi)), layout_wrc_ellipse(4))
    call same('wrc_ellipse', 'y', &
      distance(c_loc(a), c_loc(a%y)), layout_wrc_ellipse(5))
    call same('wrc_ellipse', 'normal_force', &
      distance(c_loc(a), c_loc(a%normal_force)), layout_wrc_ellipse(6))
    call same('wrc_ellipse', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_ellipse(7))
  end subroutine
  subroutine test_wrc_region()
    type(wrc_region), target :: a
    call same('wrc_region', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_region', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_region', 'size', c_sizeof(a), layout_wrc_region(1))
    call same('wrc_region', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_region(2))
    call same('wrc_region', 'available', &
      distance(c_loc(a), c_loc(a%available)), layout_wrc_region(3))
    call same('wrc_region', 'strip_count', &
      distance(c_loc(a), c_loc(a%strip_count)), layout_wrc_region(4))
    call same('wrc_region', 'cell_count', &
      distance(c_loc(a), c_loc(a%cell_count)), layout_wrc_region(5))
    call same('wrc_region', 'surface', &
      distance(c_loc(a), c_loc(a%surface)), layout_wrc_region(6))
    call same('wrc_region', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_region(7))
    call same('wrc_region', 'point', &
      distance(c_loc(a), c_loc(a%point)), layout_wrc_region(8))
    call same('wrc_region', 'normal', &
      distance(c_loc(a), c_loc(a%normal)), layout_wrc_region(9))
    call same('wrc_region', 'y_wheel', &
      distance(c_loc(a), c_loc(a%y_wheel)), layout_wrc_region(10))
    call same('wrc_region', 'z_wheel', &
      distance(c_loc(a), c_loc(a%z_wheel)), layout_wrc_region(11))
    call same('wrc_region', 'y_rail', &
      distance(c_loc(a), c_loc(a%y_rail)), layout_wrc_region(12))
    call same('wrc_region', 'z_rail', &
      distance(c_loc(a), c_loc(a%z_rail)), layout_wrc_region(13))
    call same('wrc_region', 'angle', &
      distance(c_loc(a), c_loc(a%angle)), layout_wrc_region(14))
    call same('wrc_region', 'rolling_radius', &
      distance(c_loc(a), c_loc(a%rolling_radius)), layout_wrc_region(15))
    call same('wrc_region', 'force', &
      distance(c_loc(a), c_loc(a%force)), layout_wrc_region(16))
    call same('wrc_region', 'moment', &
      distance(c_loc(a), c_loc(a%moment)), layout_wrc_region(17))
    call same('wrc_region', 'normal_force', &
      distance(c_loc(a), c_loc(a%normal_force)), layout_wrc_region(18))
    call same('wrc_region', 'longitudinal_force', &
      distance(c_loc(a), c_loc(a%longitudinal_force)), layout_wrc_region(19))
    call same('wrc_region', 'lateral_force', &
      distance(c_loc(a), c_loc(a%lateral_force)), layout_wrc_region(20))
    call same('wrc_region', 'spin_moment', &
      distance(c_loc(a), c_loc(a%spin_moment)), layout_wrc_region(21))
    call same('wrc_region', 'creepage', &
      distance(c_loc(a), c_loc(a%creepage)), layout_wrc_region(22))
    call same('wrc_region', 'ellipse', &
      distance(c_loc(a), c_loc(a%ellipse)), layout_wrc_region(23))
    call same('wrc_region', 'area', &
      distance(c_loc(a), c_loc(a%area)), layout_wrc_region(24))
    call same('wrc_region', 'length', &
      distance(c_loc(a), c_loc(a%length)), layout_wrc_region(25))
    call same('wrc_region', 'width', &
      distance(c_loc(a), c_loc(a%width)), layout_wrc_region(26))
    call same('wrc_region', 'y_min', &
      distance(c_loc(a), c_loc(a%y_min)), layout_wrc_region(27))
    call same('wrc_region', 'y_max', &
      distance(c_loc(a), c_loc(a%y_max)), layout_wrc_region(28))
    call same('wrc_region', 'peak_pressure', &
      distance(c_loc(a), c_loc(a%peak_pressure)), layout_wrc_region(29))
    call same('wrc_region', 'power', &
      distance(c_loc(a), c_loc(a%power)), layout_wrc_region(30))
    call same('wrc_region', 'adhesion_fraction', &
      distance(c_loc(a), c_loc(a%adhesion_fraction)), layout_wrc_region(31))
  end subroutine
  subroutine test_wrc_damage()
    type(wrc_damage), target :: a
    call wrc_init(a)
    call same('wrc_damage', 'size', c_sizeof(a), layout_wrc_damage(1))
    call same('wrc_damage', 'power', &
      distance(c_loc(a), c_loc(a%power)), layout_wrc_damage(2))
    call same('wrc_damage', 'peak_power_density', &
      distance(c_loc(a), c_loc(a%peak_power_density)), layout_wrc_damage(3))
    call same('wrc_damage', 't_gamma', &
      distance(c_loc(a), c_loc(a%t_gamma)), layout_wrc_damage(4))
    call same('wrc_damage', 't_gamma_no_spin', &
      distance(c_loc(a), c_loc(a%t_gamma_no_spin)), layout_wrc_damage(5))
    call same('wrc_damage', 'utilisation', &
      distance(c_loc(a), c_loc(a%utilisation)), layout_wrc_damage(6))
    call same('wrc_damage', 'load_factor', &
      distance(c_loc(a), c_loc(a%load_factor)), layout_wrc_damage(7))
    call same('wrc_damage', 'shakedown_limit', &
      distance(c_loc(a), c_loc(a%shakedown_limit)), layout_wrc_damage(8))
    call same('wrc_damage', 'fatigue_index', &
      distance(c_loc(a), c_loc(a%fatigue_index)), layout_wrc_damage(9))
    call same('wrc_damage', 'local_fatigue_index', &
      distance(c_loc(a), c_loc(a%local_fatigue_index)), layout_wrc_damage(10))
    call same('wrc_damage', 'available', &
      distance(c_loc(a), c_loc(a%available)), layout_wrc_damage(11))
    call same('wrc_damage', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_damage(12))
    call same('wrc_damage', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_damage(13))
  end subroutine
  subroutine test_wrc_planar_pose()
    type(wrc_planar_pose), target :: a
    call wrc_init(a)
    call same('wrc_planar_pose', 'size', c_sizeof(a), layout_wrc_planar_pose(1))
    call same('wrc_planar_pose', 'lateral', &
      distance(c_loc(a), c_loc(a%lateral)), layout_wrc_planar_pose(2))
    call same('wrc_planar_pose', 'roll', &
      distance(c_loc(a), c_loc(a%roll)), layout_wrc_planar_pose(3))
    call same('wrc_planar_pose', 'yaw', &
      distance(c_loc(a), c_loc(a%yaw)), layout_wrc_planar_pose(4))
    call same('wrc_planar_pose', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_planar_pose(5))
  end subroutine
  subroutine test_wrc_planar_motion()
    type(wrc_planar_motion), target :: a
    call wrc_init(a)
    call same('wrc_planar_motion', 'size', c_sizeof(a), layout_wrc_planar_motion(1))
    call same('wrc_planar_motion', 'speed', &
      distance(c_loc(a), c_loc(a%speed)), layout_wrc_planar_motion(2))
    call same('wrc_planar_motion', 'lateral_velocity', &
      distance(c_loc(a), c_loc(a%lateral_velocity)), layout_wrc_planar_motion(3))
    call same('wrc_planar_motion', 'vertical_velocity', &
      distance(c_loc(a), c_loc(a%vertical_velocity)), layout_wrc_planar_motion(4))
    call same('wrc_planar_motion', 'roll_rate', &
      distance(c_loc(a), c_loc(a%roll_rate)), layout_wrc_planar_motion(5))
    call same('wrc_planar_motion', 'yaw_rate', &
      distance(c_loc(a), c_loc(a%yaw_rate)), layout_wrc_planar_motion(6))
    call same('wrc_planar_motion', 'pitch_rate', &
      distance(c_loc(a), c_loc(a%pitch_rate)), layout_wrc_planar_motion(7))
    call same('wrc_planar_motion', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_planar_motion(8))
  end subroutine
  subroutine test_wrc_planar_point()
    type(wrc_planar_point), target :: a
    call wrc_init(a)
    call same('wrc_planar_point', 'size', c_sizeof(a), layout_wrc_planar_point(1))
    call same('wrc_planar_point', 'x', &
      distance(c_loc(a), c_loc(a%x)), layout_wrc_planar_point(2))
    call same('wrc_planar_point', 'y', &
      distance(c_loc(a), c_loc(a%y)), layout_wrc_planar_point(3))
    call same('wrc_planar_point', 'z', &
      distance(c_loc(a), c_loc(a%z)), layout_wrc_planar_point(4))
    call same('wrc_planar_point', 'y_wheel', &
      distance(c_loc(a), c_loc(a%y_wheel)), layout_wrc_planar_point(5))
    call same('wrc_planar_point', 'y_rail', &
      distance(c_loc(a), c_loc(a%y_rail)), layout_wrc_planar_point(6))
    call same('wrc_planar_point', 'angle', &
      distance(c_loc(a), c_loc(a%angle)), layout_wrc_planar_point(7))
    call same('wrc_planar_point', 'vertical_gap', &
      distance(c_loc(a), c_loc(a%vertical_gap)), layout_wrc_planar_point(8))
    call same('wrc_planar_point', 'rolling_radius', &
      distance(c_loc(a), c_loc(a%rolling_radius)), layout_wrc_planar_point(9))
    call same('wrc_planar_point', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_planar_point(10))
  end subroutine
  subroutine test_wrc_planar_gap()
    type(wrc_planar_gap), target :: a
    call wrc_init(a)
    call same('wrc_planar_gap', 'size', c_sizeof(a), layout_wrc_planar_gap(1))
    call same('wrc_planar_gap', 'row_count', &
      distance(c_loc(a), c_loc(a%row_count)), layout_wrc_planar_gap(2))
    call same('wrc_planar_gap', 'column_count', &
      distance(c_loc(a), c_loc(a%column_count)), layout_wrc_planar_gap(3))
    call same('wrc_planar_gap', 'y', &
      distance(c_loc(a), c_loc(a%y)), layout_wrc_planar_gap(4))
    call same('wrc_planar_gap', 'height', &
      distance(c_loc(a), c_loc(a%height)), layout_wrc_planar_gap(5))
    call same('wrc_planar_gap', 'centre', &
      distance(c_loc(a), c_loc(a%centre)), layout_wrc_planar_gap(6))
    call same('wrc_planar_gap', 'curvature', &
      distance(c_loc(a), c_loc(a%curvature)), layout_wrc_planar_gap(7))
    call same('wrc_planar_gap', 'x', &
      distance(c_loc(a), c_loc(a%x)), layout_wrc_planar_gap(8))
    call same('wrc_planar_gap', 'h', &
      distance(c_loc(a), c_loc(a%h)), layout_wrc_planar_gap(9))
    call same('wrc_planar_gap', 'row_stride', &
      distance(c_loc(a), c_loc(a%row_stride)), layout_wrc_planar_gap(10))
    call same('wrc_planar_gap', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_planar_gap(11))
  end subroutine
  subroutine test_wrc_planar_load()
    type(wrc_planar_load), target :: a
    call wrc_init(a)
    call same('wrc_planar_load', 'size', c_sizeof(a), layout_wrc_planar_load(1))
    call same('wrc_planar_load', 'prescribed', &
      distance(c_loc(a), c_loc(a%prescribed)), layout_wrc_planar_load(2))
    call same('wrc_planar_load', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_planar_load(3))
    call same('wrc_planar_load', 'normal_force', &
      distance(c_loc(a), c_loc(a%normal_force)), layout_wrc_planar_load(4))
    call same('wrc_planar_load', 'approach', &
      distance(c_loc(a), c_loc(a%approach)), layout_wrc_planar_load(5))
    call same('wrc_planar_load', 'approach_velocity', &
      distance(c_loc(a), c_loc(a%approach_velocity)), layout_wrc_planar_load(6))
    call same('wrc_planar_load', 'damping', &
      distance(c_loc(a), c_loc(a%damping)), layout_wrc_planar_load(7))
    call same('wrc_planar_load', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_planar_load(8))
  end subroutine
  subroutine test_wrc_planar_strips()
    type(wrc_planar_strips), target :: a
    call wrc_init(a)
    call same('wrc_planar_strips', 'size', c_sizeof(a), layout_wrc_planar_strips(1))
    call same('wrc_planar_strips', 'count', &
      distance(c_loc(a), c_loc(a%count)), layout_wrc_planar_strips(2))
    call same('wrc_planar_strips', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_planar_strips(3))
    call same('wrc_planar_strips', 'y', &
      distance(c_loc(a), c_loc(a%y)), layout_wrc_planar_strips(4))
    call same('wrc_planar_strips', 'width', &
      distance(c_loc(a), c_loc(a%width)), layout_wrc_planar_strips(5))
    call same('wrc_planar_strips', 'centre', &
      distance(c_loc(a), c_loc(a%centre)), layout_wrc_planar_strips(6))
    call same('wrc_planar_strips', 'half_length', &
      distance(c_loc(a), c_loc(a%half_length)), layout_wrc_planar_strips(7))
    call same('wrc_planar_strips', 'peak', &
      distance(c_loc(a), c_loc(a%peak)), layout_wrc_planar_strips(8))
    call same('wrc_planar_strips', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_planar_strips(9))
  end subroutine
  subroutine test_wrc_planar_normal_solution()
    type(wrc_planar_normal_solution), target :: a
    call wrc_init(a)
    call same('wrc_planar_normal_solution', 'size', c_sizeof(a), layout_wrc_planar_normal_solution(1))
    call same('wrc_planar_normal_solution', 'patch_count', &
      distance(c_loc(a), c_loc(a%patch_count)), layout_wrc_planar_normal_solution(2))
    call same('wrc_planar_normal_solution', 'strip_count', &
      distance(c_loc(a), c_loc(a%strip_count)), layout_wrc_planar_normal_solution(3))
    call same('wrc_planar_normal_solution', 'iterations', &
      distance(c_loc(a), c_loc(a%iterations)), layout_wrc_planar_normal_solution(4))
    call same('wrc_planar_normal_solution', 'flags', &
      distance(c_loc(a), c_loc(a%flags)), layout_wrc_planar_normal_solution(5))
    call same('wrc_planar_normal_solution', 'ellipse', &
      distance(c_loc(a), c_loc(a%ellipse)), layout_wrc_planar_normal_solution(6))
    call same('wrc_planar_normal_solution', 'normal_force', &
      distance(c_loc(a), c_loc(a%normal_force)), layout_wrc_planar_normal_solution(7))
    call same('wrc_planar_normal_solution', 'damping_force', &
      distance(c_loc(a), c_loc(a%damping_force)), layout_wrc_planar_normal_solution(8))
    call same('wrc_planar_normal_solution', 'approach', &
      distance(c_loc(a), c_loc(a%approach)), layout_wrc_planar_normal_solution(9))
    call same('wrc_planar_normal_solution', 'stiffness', &
      distance(c_loc(a), c_loc(a%stiffness)), layout_wrc_planar_normal_solution(10))
    call same('wrc_planar_normal_solution', 'peak_pressure', &
      distance(c_loc(a), c_loc(a%peak_pressure)), layout_wrc_planar_normal_solution(11))
    call same('wrc_planar_normal_solution', 'area', &
      distance(c_loc(a), c_loc(a%area)), layout_wrc_planar_normal_solution(12))
    call same('wrc_planar_normal_solution', 'length', &
      distance(c_loc(a), c_loc(a%length)), layout_wrc_planar_normal_solution(13))
    call same('wrc_planar_normal_solution', 'width', &
      distance(c_loc(a), c_loc(a%width)), layout_wrc_planar_normal_solution(14))
    call same('wrc_planar_normal_solution', 'y_min', &
      distance(c_loc(a), c_loc(a%y_min)), layout_wrc_planar_normal_solution(15))
    call same('wrc_planar_normal_solution', 'y_max', &
      distance(c_loc(a), c_loc(a%y_max)), layout_wrc_planar_normal_solution(16))
    call same('wrc_planar_normal_solution', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_planar_normal_solution(17))
  end subroutine
  subroutine test_wrc_planar_forces()
    type(wrc_planar_forces), target :: a
    call wrc_init(a)
    call same('wrc_planar_forces', 'size', c_sizeof(a), layout_wrc_planar_forces(1))
    call same('wrc_planar_forces', 'fx', &
      distance(c_loc(a), c_loc(a%fx)), layout_wrc_planar_forces(2))
    call same('wrc_planar_forces', 'fy', &
      distance(c_loc(a), c_loc(a%fy)), layout_wrc_planar_forces(3))
    call same('wrc_planar_forces', 'fn', &
      distance(c_loc(a), c_loc(a%fn)), layout_wrc_planar_forces(4))
    call same('wrc_planar_forces', 'mz', &
      distance(c_loc(a), c_loc(a%mz)), layout_wrc_planar_forces(5))
    call same('wrc_planar_forces', 'power', &
      distance(c_loc(a), c_loc(a%power)), layout_wrc_planar_forces(6))
    call same('wrc_planar_forces', 'adhesion_fraction', &
      distance(c_loc(a), c_loc(a%adhesion_fraction)), layout_wrc_planar_forces(7))
    call same('wrc_planar_forces', 'available', &
      distance(c_loc(a), c_loc(a%available)), layout_wrc_planar_forces(8))
    call same('wrc_planar_forces', 'flags', &
      distance(c_loc(a), c_loc(a%flags)), layout_wrc_planar_forces(9))
    call same('wrc_planar_forces', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_planar_forces(10))
  end subroutine
  subroutine test_wrc_planar_derivatives()
    type(wrc_planar_derivatives), target :: a
    call same('wrc_planar_derivatives', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_planar_derivatives', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_planar_derivatives', 'size', c_sizeof(a), layout_wrc_planar_derivatives(1))
    call same('wrc_planar_derivatives', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_planar_derivatives(2))
    call same('wrc_planar_derivatives', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_planar_derivatives(3))
    call same('wrc_planar_derivatives', 'forces', &
      distance(c_loc(a), c_loc(a%forces)), layout_wrc_planar_derivatives(4))
  end subroutine
  subroutine test_wrc_planar_input()
    type(wrc_planar_input), target :: a
    call same('wrc_planar_input', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_planar_input', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_planar_input', 'size', c_sizeof(a), layout_wrc_planar_input(1))
    call same('wrc_planar_input', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_planar_input(2))
    call same('wrc_planar_input', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_planar_input(3))
    call same('wrc_planar_input', 'pose', &
      distance(c_loc(a), c_loc(a%pose)), layout_wrc_planar_input(4))
    call same('wrc_planar_input', 'gap', &
      distance(c_loc(a), c_loc(a%gap)), layout_wrc_planar_input(5))
    call same('wrc_planar_input', 'load', &
      distance(c_loc(a), c_loc(a%load)), layout_wrc_planar_input(6))
    call same('wrc_planar_input', 'creepage', &
      distance(c_loc(a), c_loc(a%creepage)), layout_wrc_planar_input(7))
    call same('wrc_planar_input', 'friction', &
      distance(c_loc(a), c_loc(a%friction)), layout_wrc_planar_input(8))
  end subroutine
  subroutine test_wrc_planar_output()
    type(wrc_planar_output), target :: a
    call same('wrc_planar_output', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_planar_output', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_planar_output', 'size', c_sizeof(a), layout_wrc_planar_output(1))
    call same('wrc_planar_output', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_planar_output(2))
    call same('wrc_planar_output', 'flags', &
      distance(c_loc(a), c_loc(a%flags)), layout_wrc_planar_output(3))
    call same('wrc_planar_output', 'point', &
      distance(c_loc(a), c_loc(a%point)), layout_wrc_planar_output(4))
    call same('wrc_planar_output', 'normal', &
      distance(c_loc(a), c_loc(a%normal)), layout_wrc_planar_output(5))
    call same('wrc_planar_output', 'forces', &
      distance(c_loc(a), c_loc(a%forces)), layout_wrc_planar_output(6))
    call same('wrc_planar_output', 'damage', &
      distance(c_loc(a), c_loc(a%damage)), layout_wrc_planar_output(7))
  end subroutine
  subroutine test_wrc_wear_laws()
    type(wrc_wear_laws), target :: a
    call same('wrc_wear_laws', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_wear_laws', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_wear_laws', 'size', c_sizeof(a), layout_wrc_wear_laws(1))
    call same('wrc_wear_laws', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_wear_laws(2))
    call same('wrc_wear_laws', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_wear_laws(3))
    call same('wrc_wear_laws', 't_gamma_mild_end', &
      distance(c_loc(a), c_loc(a%t_gamma_mild_end)), layout_wrc_wear_laws(4))
    call same('wrc_wear_laws', 't_gamma_severe_start', &
      distance(c_loc(a), c_loc(a%t_gamma_severe_start)), layout_wrc_wear_laws(5))
    call same('wrc_wear_laws', 't_gamma_mild_slope', &
      distance(c_loc(a), c_loc(a%t_gamma_mild_slope)), layout_wrc_wear_laws(6))
    call same('wrc_wear_laws', 't_gamma_plateau', &
      distance(c_loc(a), c_loc(a%t_gamma_plateau)), layout_wrc_wear_laws(7))
    call same('wrc_wear_laws', 't_gamma_severe_slope', &
      distance(c_loc(a), c_loc(a%t_gamma_severe_slope)), layout_wrc_wear_laws(8))
    call same('wrc_wear_laws', 't_gamma_severe_offset', &
      distance(c_loc(a), c_loc(a%t_gamma_severe_offset)), layout_wrc_wear_laws(9))
    call same('wrc_wear_laws', 'sheffield_mild_end', &
      distance(c_loc(a), c_loc(a%sheffield_mild_end)), layout_wrc_wear_laws(10))
    call same('wrc_wear_laws', 'sheffield_severe_end', &
      distance(c_loc(a), c_loc(a%sheffield_severe_end)), layout_wrc_wear_laws(11))
    call same('wrc_wear_laws', 'sheffield_mild_slope', &
      distance(c_loc(a), c_loc(a%sheffield_mild_slope)), layout_wrc_wear_laws(12))
    call same('wrc_wear_laws', 'sheffield_catastrophic_slope', &
      distance(c_loc(a), c_loc(a%sheffield_catastrophic_slope)), layout_wrc_wear_laws(13))
    call same('wrc_wear_laws', 'density', &
      distance(c_loc(a), c_loc(a%density)), layout_wrc_wear_laws(14))
    call same('wrc_wear_laws', 'hardness', &
      distance(c_loc(a), c_loc(a%hardness)), layout_wrc_wear_laws(15))
    call same('wrc_wear_laws', 'archard_slow', &
      distance(c_loc(a), c_loc(a%archard_slow)), layout_wrc_wear_laws(16))
    call same('wrc_wear_laws', 'archard_severe', &
      distance(c_loc(a), c_loc(a%archard_severe)), layout_wrc_wear_laws(17))
    call same('wrc_wear_laws', 'archard_fast', &
      distance(c_loc(a), c_loc(a%archard_fast)), layout_wrc_wear_laws(18))
    call same('wrc_wear_laws', 'archard_seizure', &
      distance(c_loc(a), c_loc(a%archard_seizure)), layout_wrc_wear_laws(19))
    call same('wrc_wear_laws', 'archard_severe_start', &
      distance(c_loc(a), c_loc(a%archard_severe_start)), layout_wrc_wear_laws(20))
    call same('wrc_wear_laws', 'archard_severe_end', &
      distance(c_loc(a), c_loc(a%archard_severe_end)), layout_wrc_wear_laws(21))
    call same('wrc_wear_laws', 'seizure_pressure', &
      distance(c_loc(a), c_loc(a%seizure_pressure)), layout_wrc_wear_laws(22))
    call same('wrc_wear_laws', 'power_coefficient', &
      distance(c_loc(a), c_loc(a%power_coefficient)), layout_wrc_wear_laws(23))
    call same('wrc_wear_laws', 'power_exponent', &
      distance(c_loc(a), c_loc(a%power_exponent)), layout_wrc_wear_laws(24))
    call same('wrc_wear_laws', 'power_reference', &
      distance(c_loc(a), c_loc(a%power_reference)), layout_wrc_wear_laws(25))
  end subroutine
  subroutine test_wrc_wear()
    type(wrc_wear), target :: a
    call wrc_init(a)
    call same('wrc_wear', 'size', c_sizeof(a), layout_wrc_wear(1))
    call same('wrc_wear', 'worn_area_rate', &
      distance(c_loc(a), c_loc(a%worn_area_rate)), layout_wrc_wear(2))
    call same('wrc_wear', 'largest_depth_rate', &
      distance(c_loc(a), c_loc(a%largest_depth_rate)), layout_wrc_wear(3))
    call same('wrc_wear', 'largest_depth_velocity', &
      distance(c_loc(a), c_loc(a%largest_depth_velocity)), layout_wrc_wear(4))
    call same('wrc_wear', 'largest_power_depth_velocity', &
      distance(c_loc(a), c_loc(a%largest_power_depth_velocity)), layout_wrc_wear(5))
    call same('wrc_wear', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_wear(6))
  end subroutine
  subroutine test_wrc_coefficients()
    type(wrc_coefficients), target :: a
    call wrc_init(a)
    call same('wrc_coefficients', 'size', c_sizeof(a), layout_wrc_coefficients(1))
    call same('wrc_coefficients', 'c11', &
      distance(c_loc(a), c_loc(a%c11)), layout_wrc_coefficients(2))
    call same('wrc_coefficients', 'c22', &
      distance(c_loc(a), c_loc(a%c22)), layout_wrc_coefficients(3))
    call same('wrc_coefficients', 'c23', &
      distance(c_loc(a), c_loc(a%c23)), layout_wrc_coefficients(4))
    call same('wrc_coefficients', 'c11s', &
      distance(c_loc(a), c_loc(a%c11s)), layout_wrc_coefficients(5))
    call same('wrc_coefficients', 'c13s', &
      distance(c_loc(a), c_loc(a%c13s)), layout_wrc_coefficients(6))
    call same('wrc_coefficients', 'c22s', &
      distance(c_loc(a), c_loc(a%c22s)), layout_wrc_coefficients(7))
    call same('wrc_coefficients', 'c23s', &
      distance(c_loc(a), c_loc(a%c23s)), layout_wrc_coefficients(8))
    call same('wrc_coefficients', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_coefficients(9))
  end subroutine
  subroutine test_wrc_stress_peak()
    type(wrc_stress_peak), target :: a
    call wrc_init(a)
    call same('wrc_stress_peak', 'size', c_sizeof(a), layout_wrc_stress_peak(1))
    call same('wrc_stress_peak', 'stress', &
      distance(c_loc(a), c_loc(a%stress)), layout_wrc_stress_peak(2))
    call same('wrc_stress_peak', 'x', &
      distance(c_loc(a), c_loc(a%x)), layout_wrc_stress_peak(3))
    call same('wrc_stress_peak', 'y', &
      distance(c_loc(a), c_loc(a%y)), layout_wrc_stress_peak(4))
    call same('wrc_stress_peak', 'depth', &
      distance(c_loc(a), c_loc(a%depth)), layout_wrc_stress_peak(5))
    call same('wrc_stress_peak', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_stress_peak(6))
  end subroutine
  subroutine test_wrc_stress_peaks()
    type(wrc_stress_peaks), target :: a
    call wrc_init(a)
    call same('wrc_stress_peaks', 'size', c_sizeof(a), layout_wrc_stress_peaks(1))
    call same('wrc_stress_peaks', 'von_mises', &
      distance(c_loc(a), c_loc(a%von_mises)), layout_wrc_stress_peaks(2))
    call same('wrc_stress_peaks', 'shear', &
      distance(c_loc(a), c_loc(a%shear)), layout_wrc_stress_peaks(3))
    call same('wrc_stress_peaks', 'tension', &
      distance(c_loc(a), c_loc(a%tension)), layout_wrc_stress_peaks(4))
    call same('wrc_stress_peaks', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_stress_peaks(5))
  end subroutine
  subroutine test_wrc_stresses()
    type(wrc_stresses), target :: a
    call same('wrc_stresses', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_stresses', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_stresses', 'size', c_sizeof(a), layout_wrc_stresses(1))
    call same('wrc_stresses', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_stresses(2))
    call same('wrc_stresses', 'body', &
      distance(c_loc(a), c_loc(a%body)), layout_wrc_stresses(3))
    call same('wrc_stresses', 'largest', &
      distance(c_loc(a), c_loc(a%largest)), layout_wrc_stresses(4))
    call same('wrc_stresses', 'surface', &
      distance(c_loc(a), c_loc(a%surface)), layout_wrc_stresses(5))
    call same('wrc_stresses', 'below', &
      distance(c_loc(a), c_loc(a%below)), layout_wrc_stresses(6))
  end subroutine
  subroutine test_wrc_temperature()
    type(wrc_temperature), target :: a
    call same('wrc_temperature', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_temperature', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_temperature', 'size', c_sizeof(a), layout_wrc_temperature(1))
    call same('wrc_temperature', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_temperature(2))
    call same('wrc_temperature', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_temperature(3))
    call same('wrc_temperature', 'at_entry', &
      distance(c_loc(a), c_loc(a%at_entry)), layout_wrc_temperature(4))
    call same('wrc_temperature', 'rise', &
      distance(c_loc(a), c_loc(a%rise)), layout_wrc_temperature(5))
    call same('wrc_temperature', 'x', &
      distance(c_loc(a), c_loc(a%x)), layout_wrc_temperature(6))
    call same('wrc_temperature', 'y', &
      distance(c_loc(a), c_loc(a%y)), layout_wrc_temperature(7))
    call same('wrc_temperature', 'largest', &
      distance(c_loc(a), c_loc(a%largest)), layout_wrc_temperature(8))
    call same('wrc_temperature', 'mean_rise', &
      distance(c_loc(a), c_loc(a%mean_rise)), layout_wrc_temperature(9))
    call same('wrc_temperature', 'wheel_heat', &
      distance(c_loc(a), c_loc(a%wheel_heat)), layout_wrc_temperature(10))
    call same('wrc_temperature', 'rail_heat', &
      distance(c_loc(a), c_loc(a%rail_heat)), layout_wrc_temperature(11))
  end subroutine
  subroutine test_wrc_damage_bin()
    type(wrc_damage_bin), target :: a
    call wrc_init(a)
    call same('wrc_damage_bin', 'size', c_sizeof(a), layout_wrc_damage_bin(1))
    call same('wrc_damage_bin', 'sum', &
      distance(c_loc(a), c_loc(a%sum)), layout_wrc_damage_bin(2))
    call same('wrc_damage_bin', 'largest_pressure', &
      distance(c_loc(a), c_loc(a%largest_pressure)), layout_wrc_damage_bin(3))
    call same('wrc_damage_bin', 'largest_traction', &
      distance(c_loc(a), c_loc(a%largest_traction)), layout_wrc_damage_bin(4))
    call same('wrc_damage_bin', 'overflow', &
      distance(c_loc(a), c_loc(a%overflow)), layout_wrc_damage_bin(5))
    call same('wrc_damage_bin', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_damage_bin(6))
  end subroutine
  subroutine test_wrc_damage_bins()
    type(wrc_damage_bins), target :: a
    call same('wrc_damage_bins', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_damage_bins', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_damage_bins', 'size', c_sizeof(a), layout_wrc_damage_bins(1))
    call same('wrc_damage_bins', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_damage_bins(2))
    call same('wrc_damage_bins', 'count', &
      distance(c_loc(a), c_loc(a%count)), layout_wrc_damage_bins(3))
    call same('wrc_damage_bins', 'first', &
      distance(c_loc(a), c_loc(a%first)), layout_wrc_damage_bins(4))
    call same('wrc_damage_bins', 'width', &
      distance(c_loc(a), c_loc(a%width)), layout_wrc_damage_bins(5))
    call same('wrc_damage_bins', 'row_count', &
      distance(c_loc(a), c_loc(a%row_count)), layout_wrc_damage_bins(6))
    call same('wrc_damage_bins', 'bin_size', &
      distance(c_loc(a), c_loc(a%bin_size)), layout_wrc_damage_bins(7))
    call same('wrc_damage_bins', 'row_first', &
      distance(c_loc(a), c_loc(a%row_first)), layout_wrc_damage_bins(8))
    call same('wrc_damage_bins', 'row_length', &
      distance(c_loc(a), c_loc(a%row_length)), layout_wrc_damage_bins(9))
    call same('wrc_damage_bins', 'bins', &
      distance(c_loc(a), c_loc(a%bins)), layout_wrc_damage_bins(10))
  end subroutine
  subroutine test_wrc_fatigue_laws()
    type(wrc_fatigue_laws), target :: a
    call same('wrc_fatigue_laws', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_fatigue_laws', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_fatigue_laws', 'size', c_sizeof(a), layout_wrc_fatigue_laws(1))
    call same('wrc_fatigue_laws', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_fatigue_laws(2))
    call same('wrc_fatigue_laws', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_fatigue_laws(3))
    call same('wrc_fatigue_laws', 'whole_life_start', &
      distance(c_loc(a), c_loc(a%whole_life_start)), layout_wrc_fatigue_laws(4))
    call same('wrc_fatigue_laws', 'whole_life_peak_at', &
      distance(c_loc(a), c_loc(a%whole_life_peak_at)), layout_wrc_fatigue_laws(5))
    call same('wrc_fatigue_laws', 'whole_life_end', &
      distance(c_loc(a), c_loc(a%whole_life_end)), layout_wrc_fatigue_laws(6))
    call same('wrc_fatigue_laws', 'whole_life_peak', &
      distance(c_loc(a), c_loc(a%whole_life_peak)), layout_wrc_fatigue_laws(7))
  end subroutine
  subroutine test_wrc_accumulation()
    type(wrc_accumulation), target :: a
    call same('wrc_accumulation', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_accumulation', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_accumulation', 'size', c_sizeof(a), layout_wrc_accumulation(1))
    call same('wrc_accumulation', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_accumulation(2))
    call same('wrc_accumulation', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_accumulation(3))
    call same('wrc_accumulation', 'duration', &
      distance(c_loc(a), c_loc(a%duration)), layout_wrc_accumulation(4))
    call same('wrc_accumulation', 'distance', &
      distance(c_loc(a), c_loc(a%distance)), layout_wrc_accumulation(5))
    call same('wrc_accumulation', 'wear', &
      distance(c_loc(a), c_loc(a%wear)), layout_wrc_accumulation(6))
    call same('wrc_accumulation', 'fatigue', &
      distance(c_loc(a), c_loc(a%fatigue)), layout_wrc_accumulation(7))
  end subroutine
  subroutine test_wrc_damage_totals()
    type(wrc_damage_totals), target :: a
    call wrc_init(a)
    call same('wrc_damage_totals', 'size', c_sizeof(a), layout_wrc_damage_totals(1))
    call same('wrc_damage_totals', 'sum', &
      distance(c_loc(a), c_loc(a%sum)), layout_wrc_damage_totals(2))
    call same('wrc_damage_totals', 'largest_pressure', &
      distance(c_loc(a), c_loc(a%largest_pressure)), layout_wrc_damage_totals(3))
    call same('wrc_damage_totals', 'largest_traction', &
      distance(c_loc(a), c_loc(a%largest_traction)), layout_wrc_damage_totals(4))
    call same('wrc_damage_totals', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_damage_totals(5))
  end subroutine
  subroutine test_wrc_grid()
    type(wrc_grid), target :: a
    call wrc_init(a)
    call same('wrc_grid', 'size', c_sizeof(a), layout_wrc_grid(1))
    call same('wrc_grid', 'nx', &
      distance(c_loc(a), c_loc(a%nx)), layout_wrc_grid(2))
    call same('wrc_grid', 'ny', &
      distance(c_loc(a), c_loc(a%ny)), layout_wrc_grid(3))
    call same('wrc_grid', 'dx', &
      distance(c_loc(a), c_loc(a%dx)), layout_wrc_grid(4))
    call same('wrc_grid', 'dy', &
      distance(c_loc(a), c_loc(a%dy)), layout_wrc_grid(5))
    call same('wrc_grid', 'x0', &
      distance(c_loc(a), c_loc(a%x0)), layout_wrc_grid(6))
    call same('wrc_grid', 'y0', &
      distance(c_loc(a), c_loc(a%y0)), layout_wrc_grid(7))
    call same('wrc_grid', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_grid(8))
  end subroutine
  subroutine test_wrc_exact_normal_problem()
    type(wrc_exact_normal_problem), target :: a
    call same('wrc_exact_normal_problem', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_exact_normal_problem', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_exact_normal_problem', 'size', c_sizeof(a), layout_wrc_exact_normal_problem(1))
    call same('wrc_exact_normal_problem', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_exact_normal_problem(2))
    call same('wrc_exact_normal_problem', 'prescribed', &
      distance(c_loc(a), c_loc(a%prescribed)), layout_wrc_exact_normal_problem(3))
    call same('wrc_exact_normal_problem', 'max_iterations', &
      distance(c_loc(a), c_loc(a%max_iterations)), layout_wrc_exact_normal_problem(4))
    call same('wrc_exact_normal_problem', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_exact_normal_problem(5))
    call same('wrc_exact_normal_problem', 'normal_force', &
      distance(c_loc(a), c_loc(a%normal_force)), layout_wrc_exact_normal_problem(6))
    call same('wrc_exact_normal_problem', 'approach', &
      distance(c_loc(a), c_loc(a%approach)), layout_wrc_exact_normal_problem(7))
    call same('wrc_exact_normal_problem', 'tolerance', &
      distance(c_loc(a), c_loc(a%tolerance)), layout_wrc_exact_normal_problem(8))
    call same('wrc_exact_normal_problem', 'wheel_material', &
      distance(c_loc(a), c_loc(a%wheel_material)), layout_wrc_exact_normal_problem(9))
    call same('wrc_exact_normal_problem', 'rail_material', &
      distance(c_loc(a), c_loc(a%rail_material)), layout_wrc_exact_normal_problem(10))
    call same('wrc_exact_normal_problem', 'grid', &
      distance(c_loc(a), c_loc(a%grid)), layout_wrc_exact_normal_problem(11))
    call same('wrc_exact_normal_problem', 'gap', &
      distance(c_loc(a), c_loc(a%gap)), layout_wrc_exact_normal_problem(12))
    call same('wrc_exact_normal_problem', 'progress', &
      distance(c_loc(a), c_loc(a%progress)), layout_wrc_exact_normal_problem(13))
    call same('wrc_exact_normal_problem', 'user', &
      distance(c_loc(a), c_loc(a%user)), layout_wrc_exact_normal_problem(14))
  end subroutine
  subroutine test_wrc_exact_normal_solution()
    type(wrc_exact_normal_solution), target :: a
    call same('wrc_exact_normal_solution', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_exact_normal_solution', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_exact_normal_solution', 'size', c_sizeof(a), layout_wrc_exact_normal_solution(1))
    call same('wrc_exact_normal_solution', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_exact_normal_solution(2))
    call same('wrc_exact_normal_solution', 'iterations', &
      distance(c_loc(a), c_loc(a%iterations)), layout_wrc_exact_normal_solution(3))
    call same('wrc_exact_normal_solution', 'flags', &
      distance(c_loc(a), c_loc(a%flags)), layout_wrc_exact_normal_solution(4))
    call same('wrc_exact_normal_solution', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_exact_normal_solution(5))
    call same('wrc_exact_normal_solution', 'approach', &
      distance(c_loc(a), c_loc(a%approach)), layout_wrc_exact_normal_solution(6))
    call same('wrc_exact_normal_solution', 'normal_force', &
      distance(c_loc(a), c_loc(a%normal_force)), layout_wrc_exact_normal_solution(7))
    call same('wrc_exact_normal_solution', 'peak_pressure', &
      distance(c_loc(a), c_loc(a%peak_pressure)), layout_wrc_exact_normal_solution(8))
    call same('wrc_exact_normal_solution', 'area', &
      distance(c_loc(a), c_loc(a%area)), layout_wrc_exact_normal_solution(9))
    call same('wrc_exact_normal_solution', 'residual', &
      distance(c_loc(a), c_loc(a%residual)), layout_wrc_exact_normal_solution(10))
    call same('wrc_exact_normal_solution', 'pressure', &
      distance(c_loc(a), c_loc(a%pressure)), layout_wrc_exact_normal_solution(11))
  end subroutine
  subroutine test_wrc_exact_rolling_problem()
    type(wrc_exact_rolling_problem), target :: a
    call same('wrc_exact_rolling_problem', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_exact_rolling_problem', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_exact_rolling_problem', 'size', c_sizeof(a), layout_wrc_exact_rolling_problem(1))
    call same('wrc_exact_rolling_problem', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_exact_rolling_problem(2))
    call same('wrc_exact_rolling_problem', 'adhesion', &
      distance(c_loc(a), c_loc(a%adhesion)), layout_wrc_exact_rolling_problem(3))
    call same('wrc_exact_rolling_problem', 'collocation', &
      distance(c_loc(a), c_loc(a%collocation)), layout_wrc_exact_rolling_problem(4))
    call same('wrc_exact_rolling_problem', 'max_iterations', &
      distance(c_loc(a), c_loc(a%max_iterations)), layout_wrc_exact_rolling_problem(5))
    call same('wrc_exact_rolling_problem', 'tolerance', &
      distance(c_loc(a), c_loc(a%tolerance)), layout_wrc_exact_rolling_problem(6))
    call same('wrc_exact_rolling_problem', 'wheel_material', &
      distance(c_loc(a), c_loc(a%wheel_material)), layout_wrc_exact_rolling_problem(7))
    call same('wrc_exact_rolling_problem', 'rail_material', &
      distance(c_loc(a), c_loc(a%rail_material)), layout_wrc_exact_rolling_problem(8))
    call same('wrc_exact_rolling_problem', 'grid', &
      distance(c_loc(a), c_loc(a%grid)), layout_wrc_exact_rolling_problem(9))
    call same('wrc_exact_rolling_problem', 'pressure', &
      distance(c_loc(a), c_loc(a%pressure)), layout_wrc_exact_rolling_problem(10))
    call same('wrc_exact_rolling_problem', 'friction', &
      distance(c_loc(a), c_loc(a%friction)), layout_wrc_exact_rolling_problem(11))
    call same('wrc_exact_rolling_problem', 'coefficient', &
      distance(c_loc(a), c_loc(a%coefficient)), layout_wrc_exact_rolling_problem(12))
    call same('wrc_exact_rolling_problem', 'creepage', &
      distance(c_loc(a), c_loc(a%creepage)), layout_wrc_exact_rolling_problem(13))
    call same('wrc_exact_rolling_problem', 'progress', &
      distance(c_loc(a), c_loc(a%progress)), layout_wrc_exact_rolling_problem(14))
    call same('wrc_exact_rolling_problem', 'user', &
      distance(c_loc(a), c_loc(a%user)), layout_wrc_exact_rolling_problem(15))
    call same('wrc_exact_rolling_problem', 'layer_thickness', &
      distance(c_loc(a), c_loc(a%layer_thickness)), layout_wrc_exact_rolling_problem(16))
    call same('wrc_exact_rolling_problem', 'layer_modulus', &
      distance(c_loc(a), c_loc(a%layer_modulus)), layout_wrc_exact_rolling_problem(17))
    call same('wrc_exact_rolling_problem', 'layer_yield', &
      distance(c_loc(a), c_loc(a%layer_yield)), layout_wrc_exact_rolling_problem(18))
    call same('wrc_exact_rolling_problem', 'layer_hardening', &
      distance(c_loc(a), c_loc(a%layer_hardening)), layout_wrc_exact_rolling_problem(19))
  end subroutine
  subroutine test_wrc_exact_rolling_solution()
    type(wrc_exact_rolling_solution), target :: a
    call same('wrc_exact_rolling_solution', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_exact_rolling_solution', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_exact_rolling_solution', 'size', c_sizeof(a), layout_wrc_exact_rolling_solution(1))
    call same('wrc_exact_rolling_solution', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_exact_rolling_solution(2))
    call same('wrc_exact_rolling_solution', 'iterations', &
      distance(c_loc(a), c_loc(a%iterations)), layout_wrc_exact_rolling_solution(3))
    call same('wrc_exact_rolling_solution', 'flags', &
      distance(c_loc(a), c_loc(a%flags)), layout_wrc_exact_rolling_solution(4))
    call same('wrc_exact_rolling_solution', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_exact_rolling_solution(5))
    call same('wrc_exact_rolling_solution', 'fx', &
      distance(c_loc(a), c_loc(a%fx)), layout_wrc_exact_rolling_solution(6))
    call same('wrc_exact_rolling_solution', 'fy', &
      distance(c_loc(a), c_loc(a%fy)), layout_wrc_exact_rolling_solution(7))
    call same('wrc_exact_rolling_solution', 'mz', &
      distance(c_loc(a), c_loc(a%mz)), layout_wrc_exact_rolling_solution(8))
    call same('wrc_exact_rolling_solution', 'power', &
      distance(c_loc(a), c_loc(a%power)), layout_wrc_exact_rolling_solution(9))
    call same('wrc_exact_rolling_solution', 'power_by_balance', &
      distance(c_loc(a), c_loc(a%power_by_balance)), layout_wrc_exact_rolling_solution(10))
    call same('wrc_exact_rolling_solution', 'adhesion_fraction', &
      distance(c_loc(a), c_loc(a%adhesion_fraction)), layout_wrc_exact_rolling_solution(11))
    call same('wrc_exact_rolling_solution', 'residual', &
      distance(c_loc(a), c_loc(a%residual)), layout_wrc_exact_rolling_solution(12))
    call same('wrc_exact_rolling_solution', 'traction_x', &
      distance(c_loc(a), c_loc(a%traction_x)), layout_wrc_exact_rolling_solution(13))
    call same('wrc_exact_rolling_solution', 'traction_y', &
      distance(c_loc(a), c_loc(a%traction_y)), layout_wrc_exact_rolling_solution(14))
    call same('wrc_exact_rolling_solution', 'slip_x', &
      distance(c_loc(a), c_loc(a%slip_x)), layout_wrc_exact_rolling_solution(15))
    call same('wrc_exact_rolling_solution', 'slip_y', &
      distance(c_loc(a), c_loc(a%slip_y)), layout_wrc_exact_rolling_solution(16))
  end subroutine
  subroutine test_wrc_exact_loads()
    type(wrc_exact_loads), target :: a
    call same('wrc_exact_loads', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_exact_loads', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_exact_loads', 'size', c_sizeof(a), layout_wrc_exact_loads(1))
    call same('wrc_exact_loads', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_exact_loads(2))
    call same('wrc_exact_loads', 'body', &
      distance(c_loc(a), c_loc(a%body)), layout_wrc_exact_loads(3))
    call same('wrc_exact_loads', 'poisson', &
      distance(c_loc(a), c_loc(a%poisson)), layout_wrc_exact_loads(4))
    call same('wrc_exact_loads', 'grid', &
      distance(c_loc(a), c_loc(a%grid)), layout_wrc_exact_loads(5))
    call same('wrc_exact_loads', 'pressure', &
      distance(c_loc(a), c_loc(a%pressure)), layout_wrc_exact_loads(6))
    call same('wrc_exact_loads', 'traction_x', &
      distance(c_loc(a), c_loc(a%traction_x)), layout_wrc_exact_loads(7))
    call same('wrc_exact_loads', 'traction_y', &
      distance(c_loc(a), c_loc(a%traction_y)), layout_wrc_exact_loads(8))
  end subroutine
  subroutine test_wrc_exact_wrench_options()
    type(wrc_exact_wrench_options), target :: a
    call same('wrc_exact_wrench_options', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_exact_wrench_options', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_exact_wrench_options', 'size', c_sizeof(a), layout_wrc_exact_wrench_options(1))
    call same('wrc_exact_wrench_options', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_exact_wrench_options(2))
    call same('wrc_exact_wrench_options', 'collocation', &
      distance(c_loc(a), c_loc(a%collocation)), layout_wrc_exact_wrench_options(3))
    call same('wrc_exact_wrench_options', 'influence', &
      distance(c_loc(a), c_loc(a%influence)), layout_wrc_exact_wrench_options(4))
    call same('wrc_exact_wrench_options', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_exact_wrench_options(5))
    call same('wrc_exact_wrench_options', 'cell_x', &
      distance(c_loc(a), c_loc(a%cell_x)), layout_wrc_exact_wrench_options(6))
    call same('wrc_exact_wrench_options', 'cell_s', &
      distance(c_loc(a), c_loc(a%cell_s)), layout_wrc_exact_wrench_options(7))
    call same('wrc_exact_wrench_options', 'progress', &
      distance(c_loc(a), c_loc(a%progress)), layout_wrc_exact_wrench_options(8))
    call same('wrc_exact_wrench_options', 'user', &
      distance(c_loc(a), c_loc(a%user)), layout_wrc_exact_wrench_options(9))
  end subroutine
  subroutine test_wrc_exact_check_options()
    type(wrc_exact_check_options), target :: a
    call same('wrc_exact_check_options', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_exact_check_options', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_exact_check_options', 'size', c_sizeof(a), layout_wrc_exact_check_options(1))
    call same('wrc_exact_check_options', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_exact_check_options(2))
    call same('wrc_exact_check_options', 'nx', &
      distance(c_loc(a), c_loc(a%nx)), layout_wrc_exact_check_options(3))
    call same('wrc_exact_check_options', 'ny', &
      distance(c_loc(a), c_loc(a%ny)), layout_wrc_exact_check_options(4))
    call same('wrc_exact_check_options', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_exact_check_options(5))
    call same('wrc_exact_check_options', 'progress', &
      distance(c_loc(a), c_loc(a%progress)), layout_wrc_exact_check_options(6))
    call same('wrc_exact_check_options', 'user', &
      distance(c_loc(a), c_loc(a%user)), layout_wrc_exact_check_options(7))
  end subroutine
  subroutine test_wrc_exact_check_result()
    type(wrc_exact_check_result), target :: a
    call same('wrc_exact_check_result', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_exact_check_result', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_exact_check_result', 'size', c_sizeof(a), layout_wrc_exact_check_result(1))
    call same('wrc_exact_check_result', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_exact_check_result(2))
    call same('wrc_exact_check_result', 'flags', &
      distance(c_loc(a), c_loc(a%flags)), layout_wrc_exact_check_result(3))
    call same('wrc_exact_check_result', 'fx', &
      distance(c_loc(a), c_loc(a%fx)), layout_wrc_exact_check_result(4))
    call same('wrc_exact_check_result', 'fy', &
      distance(c_loc(a), c_loc(a%fy)), layout_wrc_exact_check_result(5))
    call same('wrc_exact_check_result', 'mz', &
      distance(c_loc(a), c_loc(a%mz)), layout_wrc_exact_check_result(6))
    call same('wrc_exact_check_result', 'power', &
      distance(c_loc(a), c_loc(a%power)), layout_wrc_exact_check_result(7))
    call same('wrc_exact_check_result', 'adhesion_fraction', &
      distance(c_loc(a), c_loc(a%adhesion_fraction)), layout_wrc_exact_check_result(8))
    call same('wrc_exact_check_result', 'force_error', &
      distance(c_loc(a), c_loc(a%force_error)), layout_wrc_exact_check_result(9))
    call same('wrc_exact_check_result', 'power_error', &
      distance(c_loc(a), c_loc(a%power_error)), layout_wrc_exact_check_result(10))
  end subroutine
  subroutine test_wrc_creep_curve()
    type(wrc_creep_curve), target :: a
    call same('wrc_creep_curve', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_creep_curve', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_creep_curve', 'size', c_sizeof(a), layout_wrc_creep_curve(1))
    call same('wrc_creep_curve', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_creep_curve(2))
    call same('wrc_creep_curve', 'count', &
      distance(c_loc(a), c_loc(a%count)), layout_wrc_creep_curve(3))
    call same('wrc_creep_curve', 'slip', &
      distance(c_loc(a), c_loc(a%slip)), layout_wrc_creep_curve(4))
    call same('wrc_creep_curve', 'adhesion', &
      distance(c_loc(a), c_loc(a%adhesion)), layout_wrc_creep_curve(5))
    call same('wrc_creep_curve', 'speed', &
      distance(c_loc(a), c_loc(a%speed)), layout_wrc_creep_curve(6))
    call same('wrc_creep_curve', 'load', &
      distance(c_loc(a), c_loc(a%load)), layout_wrc_creep_curve(7))
    call same('wrc_creep_curve', 'ellipse', &
      distance(c_loc(a), c_loc(a%ellipse)), layout_wrc_creep_curve(8))
    call same('wrc_creep_curve', 'friction', &
      distance(c_loc(a), c_loc(a%friction)), layout_wrc_creep_curve(9))
    call same('wrc_creep_curve', 'parameters', &
      distance(c_loc(a), c_loc(a%parameters)), layout_wrc_creep_curve(10))
    call same('wrc_creep_curve', 'scatter', &
      distance(c_loc(a), c_loc(a%scatter)), layout_wrc_creep_curve(11))
    call same('wrc_creep_curve', 'max_iterations', &
      distance(c_loc(a), c_loc(a%max_iterations)), layout_wrc_creep_curve(12))
    call same('wrc_creep_curve', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_creep_curve(13))
    call same('wrc_creep_curve', 'progress', &
      distance(c_loc(a), c_loc(a%progress)), layout_wrc_creep_curve(14))
    call same('wrc_creep_curve', 'user', &
      distance(c_loc(a), c_loc(a%user)), layout_wrc_creep_curve(15))
  end subroutine
  subroutine test_wrc_creep_fit()
    type(wrc_creep_fit), target :: a
    call same('wrc_creep_fit', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_creep_fit', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_creep_fit', 'size', c_sizeof(a), layout_wrc_creep_fit(1))
    call same('wrc_creep_fit', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_creep_fit(2))
    call same('wrc_creep_fit', 'flags', &
      distance(c_loc(a), c_loc(a%flags)), layout_wrc_creep_fit(3))
    call same('wrc_creep_fit', 'iterations', &
      distance(c_loc(a), c_loc(a%iterations)), layout_wrc_creep_fit(4))
    call same('wrc_creep_fit', 'undetermined', &
      distance(c_loc(a), c_loc(a%undetermined)), layout_wrc_creep_fit(5))
    call same('wrc_creep_fit', 'at_limit', &
      distance(c_loc(a), c_loc(a%at_limit)), layout_wrc_creep_fit(6))
    call same('wrc_creep_fit', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_creep_fit(7))
    call same('wrc_creep_fit', 'scatter', &
      distance(c_loc(a), c_loc(a%scatter)), layout_wrc_creep_fit(8))
    call same('wrc_creep_fit', 'friction', &
      distance(c_loc(a), c_loc(a%friction)), layout_wrc_creep_fit(9))
    call same('wrc_creep_fit', 'value', &
      distance(c_loc(a), c_loc(a%value)), layout_wrc_creep_fit(10))
    call same('wrc_creep_fit', 'deviation', &
      distance(c_loc(a), c_loc(a%deviation)), layout_wrc_creep_fit(11))
    call same('wrc_creep_fit', 'low', &
      distance(c_loc(a), c_loc(a%low)), layout_wrc_creep_fit(12))
    call same('wrc_creep_fit', 'high', &
      distance(c_loc(a), c_loc(a%high)), layout_wrc_creep_fit(13))
    call same('wrc_creep_fit', 'covariance', &
      distance(c_loc(a), c_loc(a%covariance)), layout_wrc_creep_fit(14))
  end subroutine
  subroutine test_wrc_wheelset_geometry_problem()
    type(wrc_wheelset_geometry_problem), target :: a
    call same('wrc_wheelset_geometry_problem', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_wheelset_geometry_problem', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_wheelset_geometry_problem', 'size', c_sizeof(a), layout_wrc_wheelset_geometry_problem(1))
    call same('wrc_wheelset_geometry_problem', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_wheelset_geometry_problem(2))
    call same('wrc_wheelset_geometry_problem', 'count', &
      distance(c_loc(a), c_loc(a%count)), layout_wrc_wheelset_geometry_problem(3))
    call same('wrc_wheelset_geometry_problem', 'lateral', &
      distance(c_loc(a), c_loc(a%lateral)), layout_wrc_wheelset_geometry_problem(4))
    call same('wrc_wheelset_geometry_problem', 'wheel_load', &
      distance(c_loc(a), c_loc(a%wheel_load)), layout_wrc_wheelset_geometry_problem(5))
  end subroutine
  subroutine test_wrc_wheelset_geometry()
    type(wrc_wheelset_geometry), target :: a
    call same('wrc_wheelset_geometry', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_wheelset_geometry', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_wheelset_geometry', 'size', c_sizeof(a), layout_wrc_wheelset_geometry(1))
    call same('wrc_wheelset_geometry', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_wheelset_geometry(2))
    call same('wrc_wheelset_geometry', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_wheelset_geometry(3))
    call same('wrc_wheelset_geometry', 'vertical', &
      distance(c_loc(a), c_loc(a%vertical)), layout_wrc_wheelset_geometry(4))
    call same('wrc_wheelset_geometry', 'roll', &
      distance(c_loc(a), c_loc(a%roll)), layout_wrc_wheelset_geometry(5))
    call same('wrc_wheelset_geometry', 'radius_difference', &
      distance(c_loc(a), c_loc(a%radius_difference)), layout_wrc_wheelset_geometry(6))
    call same('wrc_wheelset_geometry', 'radius_right', &
      distance(c_loc(a), c_loc(a%radius_right)), layout_wrc_wheelset_geometry(7))
    call same('wrc_wheelset_geometry', 'radius_left', &
      distance(c_loc(a), c_loc(a%radius_left)), layout_wrc_wheelset_geometry(8))
    call same('wrc_wheelset_geometry', 'angle_right', &
      distance(c_loc(a), c_loc(a%angle_right)), layout_wrc_wheelset_geometry(9))
    call same('wrc_wheelset_geometry', 'angle_left', &
      distance(c_loc(a), c_loc(a%angle_left)), layout_wrc_wheelset_geometry(10))
    call same('wrc_wheelset_geometry', 'y_wheel_right', &
      distance(c_loc(a), c_loc(a%y_wheel_right)), layout_wrc_wheelset_geometry(11))
    call same('wrc_wheelset_geometry', 'y_wheel_left', &
      distance(c_loc(a), c_loc(a%y_wheel_left)), layout_wrc_wheelset_geometry(12))
    call same('wrc_wheelset_geometry', 'y_rail_right', &
      distance(c_loc(a), c_loc(a%y_rail_right)), layout_wrc_wheelset_geometry(13))
    call same('wrc_wheelset_geometry', 'y_rail_left', &
      distance(c_loc(a), c_loc(a%y_rail_left)), layout_wrc_wheelset_geometry(14))
  end subroutine
  subroutine test_wrc_conicity_problem()
    type(wrc_conicity_problem), target :: a
    call same('wrc_conicity_problem', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_conicity_problem', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_conicity_problem', 'size', c_sizeof(a), layout_wrc_conicity_problem(1))
    call same('wrc_conicity_problem', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_conicity_problem(2))
    call same('wrc_conicity_problem', 'method', &
      distance(c_loc(a), c_loc(a%method)), layout_wrc_conicity_problem(3))
    call same('wrc_conicity_problem', 'count', &
      distance(c_loc(a), c_loc(a%count)), layout_wrc_conicity_problem(4))
    call same('wrc_conicity_problem', 'amplitude_count', &
      distance(c_loc(a), c_loc(a%amplitude_count)), layout_wrc_conicity_problem(5))
    call same('wrc_conicity_problem', 'lateral', &
      distance(c_loc(a), c_loc(a%lateral)), layout_wrc_conicity_problem(6))
    call same('wrc_conicity_problem', 'radius_difference', &
      distance(c_loc(a), c_loc(a%radius_difference)), layout_wrc_conicity_problem(7))
    call same('wrc_conicity_problem', 'amplitudes', &
      distance(c_loc(a), c_loc(a%amplitudes)), layout_wrc_conicity_problem(8))
    call same('wrc_conicity_problem', 'contact_distance', &
      distance(c_loc(a), c_loc(a%contact_distance)), layout_wrc_conicity_problem(9))
    call same('wrc_conicity_problem', 'radius', &
      distance(c_loc(a), c_loc(a%radius)), layout_wrc_conicity_problem(10))
  end subroutine
  subroutine test_wrc_conicity()
    type(wrc_conicity), target :: a
    call same('wrc_conicity', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_conicity', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_conicity', 'size', c_sizeof(a), layout_wrc_conicity(1))
    call same('wrc_conicity', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_conicity(2))
    call same('wrc_conicity', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_conicity(3))
    call same('wrc_conicity', 'conicity', &
      distance(c_loc(a), c_loc(a%conicity)), layout_wrc_conicity(4))
    call same('wrc_conicity', 'wavelength', &
      distance(c_loc(a), c_loc(a%wavelength)), layout_wrc_conicity(5))
    call same('wrc_conicity', 'centre', &
      distance(c_loc(a), c_loc(a%centre)), layout_wrc_conicity(6))
  end subroutine
  subroutine test_wrc_profile_wear()
    type(wrc_profile_wear), target :: a
    call same('wrc_profile_wear', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_profile_wear', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_profile_wear', 'size', c_sizeof(a), layout_wrc_profile_wear(1))
    call same('wrc_profile_wear', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_profile_wear(2))
    call same('wrc_profile_wear', 'body', &
      distance(c_loc(a), c_loc(a%body)), layout_wrc_profile_wear(3))
    call same('wrc_profile_wear', 'count', &
      distance(c_loc(a), c_loc(a%count)), layout_wrc_profile_wear(4))
    call same('wrc_profile_wear', 'bin_count', &
      distance(c_loc(a), c_loc(a%bin_count)), layout_wrc_profile_wear(5))
    call same('wrc_profile_wear', 'y', &
      distance(c_loc(a), c_loc(a%y)), layout_wrc_profile_wear(6))
    call same('wrc_profile_wear', 'z', &
      distance(c_loc(a), c_loc(a%z)), layout_wrc_profile_wear(7))
    call same('wrc_profile_wear', 'depth', &
      distance(c_loc(a), c_loc(a%depth)), layout_wrc_profile_wear(8))
    call same('wrc_profile_wear', 'first', &
      distance(c_loc(a), c_loc(a%first)), layout_wrc_profile_wear(9))
    call same('wrc_profile_wear', 'width', &
      distance(c_loc(a), c_loc(a%width)), layout_wrc_profile_wear(10))
    call same('wrc_profile_wear', 'passages', &
      distance(c_loc(a), c_loc(a%passages)), layout_wrc_profile_wear(11))
    call same('wrc_profile_wear', 'largest_depth', &
      distance(c_loc(a), c_loc(a%largest_depth)), layout_wrc_profile_wear(12))
    call same('wrc_profile_wear', 'smoothing', &
      distance(c_loc(a), c_loc(a%smoothing)), layout_wrc_profile_wear(13))
    call same('wrc_profile_wear', 'spacing', &
      distance(c_loc(a), c_loc(a%spacing)), layout_wrc_profile_wear(14))
  end subroutine
  subroutine test_wrc_worn_profile()
    type(wrc_worn_profile), target :: a
    call same('wrc_worn_profile', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_worn_profile', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_worn_profile', 'size', c_sizeof(a), layout_wrc_worn_profile(1))
    call same('wrc_worn_profile', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_worn_profile(2))
    call same('wrc_worn_profile', 'capacity', &
      distance(c_loc(a), c_loc(a%capacity)), layout_wrc_worn_profile(3))
    call same('wrc_worn_profile', 'count', &
      distance(c_loc(a), c_loc(a%count)), layout_wrc_worn_profile(4))
    call same('wrc_worn_profile', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_worn_profile(5))
    call same('wrc_worn_profile', 'y', &
      distance(c_loc(a), c_loc(a%y)), layout_wrc_worn_profile(6))
    call same('wrc_worn_profile', 'z', &
      distance(c_loc(a), c_loc(a%z)), layout_wrc_worn_profile(7))
    call same('wrc_worn_profile', 'passages', &
      distance(c_loc(a), c_loc(a%passages)), layout_wrc_worn_profile(8))
    call same('wrc_worn_profile', 'depth', &
      distance(c_loc(a), c_loc(a%depth)), layout_wrc_worn_profile(9))
    call same('wrc_worn_profile', 'area', &
      distance(c_loc(a), c_loc(a%area)), layout_wrc_worn_profile(10))
  end subroutine
  subroutine test_wrc_flange()
    type(wrc_flange), target :: a
    call wrc_init(a)
    call same('wrc_flange', 'size', c_sizeof(a), layout_wrc_flange(1))
    call same('wrc_flange', 'height', &
      distance(c_loc(a), c_loc(a%height)), layout_wrc_flange(2))
    call same('wrc_flange', 'thickness', &
      distance(c_loc(a), c_loc(a%thickness)), layout_wrc_flange(3))
    call same('wrc_flange', 'slope', &
      distance(c_loc(a), c_loc(a%slope)), layout_wrc_flange(4))
    call same('wrc_flange', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_flange(5))
  end subroutine
  subroutine test_wrc_section_line()
    type(wrc_section_line), target :: a
    call wrc_init(a)
    call same('wrc_section_line', 'size', c_sizeof(a), layout_wrc_section_line(1))
    call same('wrc_section_line', 'distance', &
      distance(c_loc(a), c_loc(a%distance)), layout_wrc_section_line(2))
    call same('wrc_section_line', 'count', &
      distance(c_loc(a), c_loc(a%count)), layout_wrc_section_line(3))
    call same('wrc_section_line', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_section_line(4))
    call same('wrc_section_line', 'y', &
      distance(c_loc(a), c_loc(a%y)), layout_wrc_section_line(5))
    call same('wrc_section_line', 'z', &
      distance(c_loc(a), c_loc(a%z)), layout_wrc_section_line(6))
    call same('wrc_section_line', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_section_line(7))
  end subroutine
  subroutine test_wrc_rail_faces_problem()
    type(wrc_rail_faces_problem), target :: a
    call same('wrc_rail_faces_problem', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_rail_faces_problem', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_rail_faces_problem', 'size', c_sizeof(a), layout_wrc_rail_faces_problem(1))
    call same('wrc_rail_faces_problem', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_rail_faces_problem(2))
    call same('wrc_rail_faces_problem', 'section_count', &
      distance(c_loc(a), c_loc(a%section_count)), layout_wrc_rail_faces_problem(3))
    call same('wrc_rail_faces_problem', 'sections', &
      distance(c_loc(a), c_loc(a%sections)), layout_wrc_rail_faces_problem(4))
    call same('wrc_rail_faces_problem', 'interruption_count', &
      distance(c_loc(a), c_loc(a%interruption_count)), layout_wrc_rail_faces_problem(5))
    call same('wrc_rail_faces_problem', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_rail_faces_problem(6))
    call same('wrc_rail_faces_problem', 'interruptions', &
      distance(c_loc(a), c_loc(a%interruptions)), layout_wrc_rail_faces_problem(7))
    call same('wrc_rail_faces_problem', 'first', &
      distance(c_loc(a), c_loc(a%first)), layout_wrc_rail_faces_problem(8))
    call same('wrc_rail_faces_problem', 'last', &
      distance(c_loc(a), c_loc(a%last)), layout_wrc_rail_faces_problem(9))
    call same('wrc_rail_faces_problem', 'depth', &
      distance(c_loc(a), c_loc(a%depth)), layout_wrc_rail_faces_problem(10))
    call same('wrc_rail_faces_problem', 'gap', &
      distance(c_loc(a), c_loc(a%gap)), layout_wrc_rail_faces_problem(11))
    call same('wrc_rail_faces_problem', 'kink', &
      distance(c_loc(a), c_loc(a%kink)), layout_wrc_rail_faces_problem(12))
    call same('wrc_rail_faces_problem', 'least_width', &
      distance(c_loc(a), c_loc(a%least_width)), layout_wrc_rail_faces_problem(13))
    call same('wrc_rail_faces_problem', 'tolerance', &
      distance(c_loc(a), c_loc(a%tolerance)), layout_wrc_rail_faces_problem(14))
  end subroutine
  subroutine test_wrc_found_faces()
    type(wrc_found_faces), target :: a
    call same('wrc_found_faces', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_found_faces', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_found_faces', 'size', c_sizeof(a), layout_wrc_found_faces(1))
    call same('wrc_found_faces', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_found_faces(2))
    call same('wrc_found_faces', 'face_count', &
      distance(c_loc(a), c_loc(a%face_count)), layout_wrc_found_faces(3))
    call same('wrc_found_faces', 'outline_count', &
      distance(c_loc(a), c_loc(a%outline_count)), layout_wrc_found_faces(4))
    call same('wrc_found_faces', 'rail_section_count', &
      distance(c_loc(a), c_loc(a%rail_section_count)), layout_wrc_found_faces(5))
    call same('wrc_found_faces', 'rail_section_size', &
      distance(c_loc(a), c_loc(a%rail_section_size)), layout_wrc_found_faces(6))
    call same('wrc_found_faces', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_found_faces(7))
    call same('wrc_found_faces', 'rail_sections', &
      distance(c_loc(a), c_loc(a%rail_sections)), layout_wrc_found_faces(8))
    call same('wrc_found_faces', 'notes', &
      distance(c_loc(a), c_loc(a%notes)), layout_wrc_found_faces(9))
    call same('wrc_found_faces', 'thin', &
      distance(c_loc(a), c_loc(a%thin)), layout_wrc_found_faces(10))
  end subroutine
  subroutine test_wrc_face_outline()
    type(wrc_face_outline), target :: a
    call same('wrc_face_outline', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_face_outline', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_face_outline', 'size', c_sizeof(a), layout_wrc_face_outline(1))
    call same('wrc_face_outline', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_face_outline(2))
    call same('wrc_face_outline', 'kind', &
      distance(c_loc(a), c_loc(a%kind)), layout_wrc_face_outline(3))
    call same('wrc_face_outline', 'face', &
      distance(c_loc(a), c_loc(a%face)), layout_wrc_face_outline(4))
    call same('wrc_face_outline', 'number', &
      distance(c_loc(a), c_loc(a%number)), layout_wrc_face_outline(5))
    call same('wrc_face_outline', 'count', &
      distance(c_loc(a), c_loc(a%count)), layout_wrc_face_outline(6))
    call same('wrc_face_outline', 'mark_count', &
      distance(c_loc(a), c_loc(a%mark_count)), layout_wrc_face_outline(7))
    call same('wrc_face_outline', 'distance', &
      distance(c_loc(a), c_loc(a%distance)), layout_wrc_face_outline(8))
    call same('wrc_face_outline', 'spacing_error', &
      distance(c_loc(a), c_loc(a%spacing_error)), layout_wrc_face_outline(9))
    call same('wrc_face_outline', 'y', &
      distance(c_loc(a), c_loc(a%y)), layout_wrc_face_outline(10))
    call same('wrc_face_outline', 'z', &
      distance(c_loc(a), c_loc(a%z)), layout_wrc_face_outline(11))
    call same('wrc_face_outline', 'marks', &
      distance(c_loc(a), c_loc(a%marks)), layout_wrc_face_outline(12))
  end subroutine
  subroutine test_wrc_surface_bin()
    type(wrc_surface_bin), target :: a
    call wrc_init(a)
    call same('wrc_surface_bin', 'size', c_sizeof(a), layout_wrc_surface_bin(1))
    call same('wrc_surface_bin', 'sum', &
      distance(c_loc(a), c_loc(a%sum)), layout_wrc_surface_bin(2))
    call same('wrc_surface_bin', 'overflow', &
      distance(c_loc(a), c_loc(a%overflow)), layout_wrc_surface_bin(3))
    call same('wrc_surface_bin', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_surface_bin(4))
  end subroutine
  subroutine test_wrc_surface()
    type(wrc_surface), target :: a
    call same('wrc_surface', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_surface', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_surface', 'size', c_sizeof(a), layout_wrc_surface(1))
    call same('wrc_surface', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_surface(2))
    call same('wrc_surface', 'count', &
      distance(c_loc(a), c_loc(a%count)), layout_wrc_surface(3))
    call same('wrc_surface', 'first', &
      distance(c_loc(a), c_loc(a%first)), layout_wrc_surface(4))
    call same('wrc_surface', 'length', &
      distance(c_loc(a), c_loc(a%length)), layout_wrc_surface(5))
    call same('wrc_surface', 'width', &
      distance(c_loc(a), c_loc(a%width)), layout_wrc_surface(6))
    call same('wrc_surface', 'closed', &
      distance(c_loc(a), c_loc(a%closed)), layout_wrc_surface(7))
    call same('wrc_surface', 'bin_size', &
      distance(c_loc(a), c_loc(a%bin_size)), layout_wrc_surface(8))
    call same('wrc_surface', 'bins', &
      distance(c_loc(a), c_loc(a%bins)), layout_wrc_surface(9))
    call same('wrc_surface', 'rows', &
      distance(c_loc(a), c_loc(a%rows)), layout_wrc_surface(10))
    call same('wrc_surface', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_surface(11))
    call same('wrc_surface', 'row_first', &
      distance(c_loc(a), c_loc(a%row_first)), layout_wrc_surface(12))
  end subroutine
  subroutine test_wrc_substance()
    type(wrc_substance), target :: a
    call wrc_init(a)
    call same('wrc_substance', 'size', c_sizeof(a), layout_wrc_substance(1))
    call same('wrc_substance', 'cover', &
      distance(c_loc(a), c_loc(a%cover)), layout_wrc_substance(2))
    call same('wrc_substance', 'weight', &
      distance(c_loc(a), c_loc(a%weight)), layout_wrc_substance(3))
    call same('wrc_substance', 'friction', &
      distance(c_loc(a), c_loc(a%friction)), layout_wrc_substance(4))
    call same('wrc_substance', 'wet_friction', &
      distance(c_loc(a), c_loc(a%wet_friction)), layout_wrc_substance(5))
    call same('wrc_substance', 'removal', &
      distance(c_loc(a), c_loc(a%removal)), layout_wrc_substance(6))
    call same('wrc_substance', 'kept', &
      distance(c_loc(a), c_loc(a%kept)), layout_wrc_substance(7))
    call same('wrc_substance', 'squeeze', &
      distance(c_loc(a), c_loc(a%squeeze)), layout_wrc_substance(8))
    call same('wrc_substance', 'carry', &
      distance(c_loc(a), c_loc(a%carry)), layout_wrc_substance(9))
    call same('wrc_substance', 'density', &
      distance(c_loc(a), c_loc(a%density)), layout_wrc_substance(10))
    call same('wrc_substance', 'layer_modulus', &
      distance(c_loc(a), c_loc(a%layer_modulus)), layout_wrc_substance(11))
    call same('wrc_substance', 'layer_yield', &
      distance(c_loc(a), c_loc(a%layer_yield)), layout_wrc_substance(12))
    call same('wrc_substance', 'layer_hardening', &
      distance(c_loc(a), c_loc(a%layer_hardening)), layout_wrc_substance(13))
    call same('wrc_substance', 'reserved', &
      distance(c_loc(a), c_loc(a%reserved)), layout_wrc_substance(14))
  end subroutine
  subroutine test_wrc_surface_laws()
    type(wrc_surface_laws), target :: a
    call same('wrc_surface_laws', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_surface_laws', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_surface_laws', 'size', c_sizeof(a), layout_wrc_surface_laws(1))
    call same('wrc_surface_laws', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_surface_laws(2))
    call same('wrc_surface_laws', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_surface_laws(3))
    call same('wrc_surface_laws', 'water', &
      distance(c_loc(a), c_loc(a%water)), layout_wrc_surface_laws(4))
    call same('wrc_surface_laws', 'oxide', &
      distance(c_loc(a), c_loc(a%oxide)), layout_wrc_surface_laws(5))
    call same('wrc_surface_laws', 'film', &
      distance(c_loc(a), c_loc(a%film)), layout_wrc_surface_laws(6))
    call same('wrc_surface_laws', 'sand', &
      distance(c_loc(a), c_loc(a%sand)), layout_wrc_surface_laws(7))
    call same('wrc_surface_laws', 'lubricant', &
      distance(c_loc(a), c_loc(a%lubricant)), layout_wrc_surface_laws(8))
    call same('wrc_surface_laws', 'rail_share', &
      distance(c_loc(a), c_loc(a%rail_share)), layout_wrc_surface_laws(9))
    call same('wrc_surface_laws', 'rail_heat_capacity', &
      distance(c_loc(a), c_loc(a%rail_heat_capacity)), layout_wrc_surface_laws(10))
    call same('wrc_surface_laws', 'wheel_heat_capacity', &
      distance(c_loc(a), c_loc(a%wheel_heat_capacity)), layout_wrc_surface_laws(11))
    call same('wrc_surface_laws', 'cooling_time', &
      distance(c_loc(a), c_loc(a%cooling_time)), layout_wrc_surface_laws(12))
    call same('wrc_surface_laws', 'drying_time', &
      distance(c_loc(a), c_loc(a%drying_time)), layout_wrc_surface_laws(13))
    call same('wrc_surface_laws', 'evaporation_share', &
      distance(c_loc(a), c_loc(a%evaporation_share)), layout_wrc_surface_laws(14))
    call same('wrc_surface_laws', 'evaporation_amount', &
      distance(c_loc(a), c_loc(a%evaporation_amount)), layout_wrc_surface_laws(15))
    call same('wrc_surface_laws', 'latent_heat', &
      distance(c_loc(a), c_loc(a%latent_heat)), layout_wrc_surface_laws(16))
    call same('wrc_surface_laws', 'ambient', &
      distance(c_loc(a), c_loc(a%ambient)), layout_wrc_surface_laws(17))
  end subroutine
  subroutine test_wrc_surface_passage()
    type(wrc_surface_passage), target :: a
    call same('wrc_surface_passage', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_surface_passage', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_surface_passage', 'size', c_sizeof(a), layout_wrc_surface_passage(1))
    call same('wrc_surface_passage', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_surface_passage(2))
    call same('wrc_surface_passage', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_surface_passage(3))
    call same('wrc_surface_passage', 'rail_from', &
      distance(c_loc(a), c_loc(a%rail_from)), layout_wrc_surface_passage(4))
    call same('wrc_surface_passage', 'rail_to', &
      distance(c_loc(a), c_loc(a%rail_to)), layout_wrc_surface_passage(5))
    call same('wrc_surface_passage', 'wheel_from', &
      distance(c_loc(a), c_loc(a%wheel_from)), layout_wrc_surface_passage(6))
    call same('wrc_surface_passage', 'wheel_to', &
      distance(c_loc(a), c_loc(a%wheel_to)), layout_wrc_surface_passage(7))
    call same('wrc_surface_passage', 'energy', &
      distance(c_loc(a), c_loc(a%energy)), layout_wrc_surface_passage(8))
    call same('wrc_surface_passage', 'film_rows', &
      distance(c_loc(a), c_loc(a%film_rows)), layout_wrc_surface_passage(9))
    call same('wrc_surface_passage', 'film_numbers', &
      distance(c_loc(a), c_loc(a%film_numbers)), layout_wrc_surface_passage(10))
    call same('wrc_surface_passage', 'reserved1', &
      distance(c_loc(a), c_loc(a%reserved1)), layout_wrc_surface_passage(11))
    call same('wrc_surface_passage', 'contact', &
      distance(c_loc(a), c_loc(a%contact)), layout_wrc_surface_passage(12))
  end subroutine
  subroutine test_wrc_surface_exchange()
    type(wrc_surface_exchange), target :: a
    call same('wrc_surface_exchange', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    a%struct_size = 0  ! of a variable that was used before
    call wrc_init(a)
    call same('wrc_surface_exchange', 'struct_size', int(a%struct_size, c_size_t), c_sizeof(a))
    call same('wrc_surface_exchange', 'size', c_sizeof(a), layout_wrc_surface_exchange(1))
    call same('wrc_surface_exchange', 'struct_size', &
      distance(c_loc(a), c_loc(a%struct_size)), layout_wrc_surface_exchange(2))
    call same('wrc_surface_exchange', 'reserved0', &
      distance(c_loc(a), c_loc(a%reserved0)), layout_wrc_surface_exchange(3))
    call same('wrc_surface_exchange', 'carried', &
      distance(c_loc(a), c_loc(a%carried)), layout_wrc_surface_exchange(4))
    call same('wrc_surface_exchange', 'rail_energy', &
      distance(c_loc(a), c_loc(a%rail_energy)), layout_wrc_surface_exchange(5))
    call same('wrc_surface_exchange', 'wheel_energy', &
      distance(c_loc(a), c_loc(a%wheel_energy)), layout_wrc_surface_exchange(6))
    call same('wrc_surface_exchange', 'beside_energy', &
      distance(c_loc(a), c_loc(a%beside_energy)), layout_wrc_surface_exchange(7))
  end subroutine
  function distance(from, to) result(bytes)
    type(c_ptr), intent(in) :: from, to
    integer(c_size_t) :: bytes
    bytes = transfer(to, bytes) - transfer(from, bytes)
  end function
  subroutine same(struct, member, here, there)
    character(*), intent(in) :: struct, member
    integer(c_size_t), intent(in) :: here, there
    if (here == there) return
    print '(4a,i0,a,i0)', struct, '%', member, ': Fortran ', here, ', C ', there
    failures = failures + 1
  end subroutine
end program
