"""The flat wheel call of libwrc through ctypes: a model, contacts, 21 numbers in, 18 out (wrc_wheel.h)."""
import ctypes as c


def numbers(kind, names):
    return [(name, kind) for name in names.split()]


def struct(name, *fields):
    return type(name, (c.Structure,), {"_fields_": [each for group in fields for each in group]})


Profile = struct("Profile", [("kind", c.c_int32), ("count", c.c_uint32), ("y", c.c_void_p), ("z", c.c_void_p),
                             ("smoothing", c.c_double)])
Config = struct(  # wrc_config
    "Config", numbers(c.c_int32, "struct_size instruction_set"), [("wheel", Profile), ("rail", Profile)],
    [("material", struct("Material", numbers(c.c_double, "shear_modulus poisson shear_yield"))),
     ("wheelset", struct("Wheelset", numbers(c.c_double, "wheel_radius flange_back_distance"))),
     ("track", struct("Track", numbers(c.c_int32, "placement reserved"),
                      numbers(c.c_double, "gauge gauge_depth rail_inclination rail_origin"))),
     ("grid", struct("Grid", numbers(c.c_int32, "strips cells gap_rows max_patches"), numbers(c.c_double, "gap_limit"))),
     ("normal", struct("Normal", numbers(c.c_int32, "method max_iterations max_sweeps warm_start"),
                       numbers(c.c_double, "load_tolerance"))),
     ("tangential", struct("Tangential", numbers(c.c_int32, "method patch_model bound flexibility regularisation reserved"),
                           [("force_table", c.c_char_p)]))])


class Region(c.Structure):
    _fields_ = ([("struct_size", c.c_uint32), ("reserved", c.c_uint32), ("point", c.c_double * 3)] +
                [(n, c.c_double) for n in "y_wheel z_wheel y_rail z_rail angle normal_force".split()] +
                [("force", c.c_double * 3), ("moment", c.c_double * 3)] +
                [(n, c.c_double) for n in "area peak_pressure power".split()] + [("creepage", c.c_double * 3)])


S1002, RAIL_60E1, UIC60_BENCHMARK = 2, 3, 4
RIGHT, LEFT = 0, 1
HEIGHT, LOAD = 0, 1


class Model:
    """One model for all wheels; contact() makes a contact, step() solves one, regions() tells of the last solution."""

    def __init__(self, library, shear_modulus=82e9, poisson=0.28, rail=UIC60_BENCHMARK):
        self.lib = lib = c.CDLL(library)
        lib.wrc_contact_last_error.argtypes = [c.c_void_p, c.c_char_p, c.c_uint64]
        lib.wrc_contact_wrench_flat.argtypes = [c.c_void_p, c.c_void_p, c.c_void_p]
        lib.wrc_contact_region.argtypes = [c.c_void_p, c.c_int32, c.c_void_p]
        lib.wrc_contact_create.argtypes = [c.c_void_p, c.c_int32, c.c_void_p, c.POINTER(c.c_void_p)]
        config = Config(c.sizeof(Config))
        assert lib.wrc_config_init(c.byref(config)) == 0
        config.wheel.kind, config.rail.kind = S1002, rail
        config.material.shear_modulus, config.material.poisson = shear_modulus, poisson
        self.model = c.c_void_p()
        text = c.create_string_buffer(400)
        if lib.wrc_model_create(c.byref(config), None, c.byref(self.model)) < 0:
            lib.wrc_config_check(c.byref(config), text, c.c_uint64(400))
            raise RuntimeError(text.value.decode())
        self.numbers_in, self.numbers_out = (c.c_double * 21)(), (c.c_double * 18)()
        self.calls = 0
        self.statuses = {}

    def contact(self, side):
        contact = c.c_void_p()
        assert self.lib.wrc_contact_create(self.model, side, None, c.byref(contact)) == 0
        return contact

    def step(self, contact, given):
        """given: the numbers of wrc_contact_wrench_flat(). Returns its outputs as a list."""
        self.numbers_in[:] = given
        status = self.lib.wrc_contact_wrench_flat(contact, self.numbers_in, self.numbers_out)
        self.calls += 1
        self.statuses[status] = self.statuses.get(status, 0) + 1
        if status < 0:
            text = c.create_string_buffer(400)
            self.lib.wrc_contact_last_error(contact, text, 400)
            raise RuntimeError(text.value.decode())
        return list(self.numbers_out)

    def regions(self, contact):
        """(y_wheel [m], angle [rad], normal force [N]) of each region of the last solution."""
        found, region = [], Region(c.sizeof(Region))
        while len(found) < self.numbers_out[17] and self.lib.wrc_contact_region(contact, len(found), c.byref(region)) >= 0:
            found.append((region.y_wheel, region.angle, region.normal_force))
        return found
