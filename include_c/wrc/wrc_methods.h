/** @file wrc_methods.h
 * The methods a model can be made of, and the published names of their combinations; wrc.h includes it. The library's
 * table of methods is in the order of these values. */
#ifndef WRC_METHODS_H
#define WRC_METHODS_H

/** Method of the normal problem. */
enum wrc_normal_method {
  WRC_NORMAL_HERTZ = 0,           /**< one ellipse; lateral curvature from the chord of the gap at half the approach */
  WRC_NORMAL_KIK_PIOTROWSKI = 1,  /**< Kik and Piotrowski, VSD 46 (2008) */
  WRC_NORMAL_EKP = 2,             /**< extended Kik-Piotrowski, after VSD 54 (2016): yaw, lateral curvature */
  WRC_NORMAL_EKP_ELLIPSE = 3,     /**< threshold varying over y, every region of overlap: CONTACT's KPEC, to 0.02 % */
  WRC_NORMAL_ANALYN = 4,          /**< ANALYN in the modified form, after VSD 52 (2014); unconfirmed */
  WRC_NORMAL_STRIPES = 5,         /**< STRIPES, semi-Hertzian, after VSD 43 (2005); unconfirmed */
  WRC_NORMAL_STRIP_HALFSPACE = 6  /**< strips of own peak and length in half-space equilibrium; several patches */
};

/** Method of the tangential problem. All but FASTSIM have the bound friction * pressure. */
enum wrc_tangential_method {
  WRC_TANGENTIAL_FASTSIM = 0,          /**< FASTSIM, Kalker 1982, marched in second order, with patch_model, bound and
                                            flexibility of config.tangential; modified FASTSIM where
                                            friction.slope_fall > 0 */
  WRC_TANGENTIAL_FASTRIP = 1,          /**< FaStrip, VSD 54 (2016), with config.tangential.patch_model: strip theory where it
                                            sticks, FASTSIM's directions where it slips */
  WRC_TANGENTIAL_STRIP_FASTSIM = 2,    /**< FASTSIM in the shape of strip theory on the patch as it is, calibrated on
                                            exact solutions */
  WRC_TANGENTIAL_FORCE_TABLE = 3,      /**< total forces from config.tangential.force_table, exact solutions for double
                                            ellipses: no tractions, no slip, and no results that need them */
  WRC_TANGENTIAL_POLACH = 4            /**< Polach's force law on the equivalent ellipse, with friction.adhesion_reduction and
                                            slip_reduction: total forces, no tractions and no slip */
};

/** Patch of FASTSIM and FaStrip: the strips that carry tractions, and the shape whose coefficients of linear theory they
 * have. The ellipse has the semi-axes of the equivalent double ellipse, a and b of wrc_ellipse. */
enum wrc_patch_model {
  WRC_PATCH_MODEL_PATCH_SDEC = 0,        /**< the patch; coefficients of its equivalent double ellipse */
  WRC_PATCH_MODEL_PATCH_ELLIPSE = 1,     /**< the patch; coefficients of the equivalent ellipse */
  WRC_PATCH_MODEL_ELLIPSE_AT_MIDDLE = 2, /**< the equivalent ellipse about mid-width, creepage corrected for the shift */
  WRC_PATCH_MODEL_ELLIPSE_AT_POINT = 3   /**< the equivalent ellipse about the contact point: no psi */
};

/** Criteria by which a patch gets its equivalent double ellipse. */
enum wrc_regularisation {
  WRC_REGULARISE_KEEP_WIDTH = 0, /**< criteria (1), (2b), (3): area and width kept; the paper's choice */
  WRC_REGULARISE_KEEP_RATIO = 1  /**< criteria (1), (2), (3): area and length/width ratio kept (KBTNH) */
};

/** Form of the traction bound along a strip. Over the patch each integrates to friction * load where friction is uniform. */
enum wrc_traction_bound {
  WRC_BOUND_PARABOLIC = 0,  /**< paper eq. 9: right slope at the leading edge */
  WRC_BOUND_ELLIPTIC = 1,   /**< friction * pressure: the actual pressure of each strip */
  WRC_BOUND_ELLIPSOIDAL = 2 /**< friction * load spread as sqrt(x_l^2 - x^2): the pressure of a Kik-Piotrowski patch. On double
                                 ellipses the same as ELLIPTIC */
};

/** How the flexibilities of linear theory enter FASTSIM. */
enum wrc_flexibility {
  WRC_FLEXIBILITY_SEPARATE = 0, /**< one for each force of linear theory: right for small creepage */
  WRC_FLEXIBILITY_SINGLE = 1,   /**< Kalker's weighted sum for all: right traction directions at large creepage */
  WRC_FLEXIBILITY_BLENDED = 2   /**< from the first to the second as creepage grows; Vollebregt and Voltr, VSD 61 (2023) */
};

/** The normal methods, X(identifier, value), for programs that go through all of them. */
#define WRC_NORMAL_METHOD_LIST(X)              \
  X(hertz, WRC_NORMAL_HERTZ)                   \
  X(kik_piotrowski, WRC_NORMAL_KIK_PIOTROWSKI) \
  X(ekp, WRC_NORMAL_EKP)                       \
  X(ekp_ellipse, WRC_NORMAL_EKP_ELLIPSE)       \
  X(analyn, WRC_NORMAL_ANALYN)                 \
  X(stripes, WRC_NORMAL_STRIPES)               \
  X(strip_halfspace, WRC_NORMAL_STRIP_HALFSPACE)

/** The tangential methods by their published names, X(identifier, name, WRC_TANGENTIAL_..., WRC_PATCH_MODEL_...,
 * WRC_BOUND_..., WRC_FLEXIBILITY_..., WRC_REGULARISE_..., slope falls). wrc_config_use() sets a configuration by name;
 * bound, flexibilities and regularisation may then be chosen otherwise where the method reads them. The last column is
 * 1 where friction.slope_fall > 0 belongs to the name.
 * Sources: FASTSIM, Kalker, VSD 11 (1982). FASTSIM-EQ.E, -EQ.L,
 * -SDEC, Liu and Bruni (the paper of wrc.h). FaStrip and its modified form, Sichani, Enblom and Berg, VSD 54 (2016);
 * FaStrip-SDEC, own. Modified FASTSIM, Spiryagin, Polach and Cole, VSD 51 (2013). KBTNH-type table, after Piotrowski,
 * Liu and Bruni, VSD 55 (2017). Polach, VSD 33 supplement (1999) and Wear 258 (2005). Strip FASTSIM: own. */
#define WRC_PRESET_LIST(X)                                                                                       \
  X(fastsim, "FASTSIM", FASTSIM, ELLIPSE_AT_POINT, PARABOLIC, SEPARATE, KEEP_WIDTH, 0)                           \
  X(fastsim_eqe, "FASTSIM-EQ.E", FASTSIM, ELLIPSE_AT_MIDDLE, PARABOLIC, SEPARATE, KEEP_WIDTH, 0)                 \
  X(fastsim_eql, "FASTSIM-EQ.L", FASTSIM, PATCH_ELLIPSE, PARABOLIC, SEPARATE, KEEP_WIDTH, 0)                     \
  X(fastsim_sdec, "FASTSIM-SDEC", FASTSIM, PATCH_SDEC, PARABOLIC, SEPARATE, KEEP_WIDTH, 0)                       \
  X(strip_fastsim, "strip FASTSIM", STRIP_FASTSIM, PATCH_SDEC, PARABOLIC, SEPARATE, KEEP_WIDTH, 0)               \
  X(table, "KBTNH-type table", FORCE_TABLE, PATCH_SDEC, PARABOLIC, SEPARATE, KEEP_WIDTH, 0)                      \
  X(modified_fastsim, "modified FASTSIM", FASTSIM, PATCH_ELLIPSE, PARABOLIC, SEPARATE, KEEP_WIDTH, 1)            \
  X(fastrip, "FaStrip", FASTRIP, ELLIPSE_AT_POINT, PARABOLIC, SEPARATE, KEEP_WIDTH, 0)                           \
  X(fastrip_modified, "modified FaStrip", FASTRIP, PATCH_ELLIPSE, PARABOLIC, SEPARATE, KEEP_WIDTH, 0)            \
  X(fastrip_sdec, "FaStrip-SDEC", FASTRIP, PATCH_SDEC, PARABOLIC, SEPARATE, KEEP_WIDTH, 0)                       \
  X(polach, "Polach", POLACH, PATCH_SDEC, PARABOLIC, SEPARATE, KEEP_WIDTH, 0)

/** Resolutions of wrc_contact_wrench() by name: X(identifier, "name", tread_width [m], corner_width [m], tolerance, max_work,
 * max_iterations), those of config.surface. docs/realtime.md has their times and errors. */
#define WRC_RESOLUTION_LIST(X)                                     \
  X(standard, "default", 0.5e-3, 0.25e-3, 1e-5, 2e7, 1e6)          \
  X(real_time, "real time", 1e-3, 0.25e-3, 1e-3, 1e6, 8)           \
  X(reference, "reference", 0.25e-3, 0.125e-3, 1e-9, 1e8, 1e6)

/** Friction and layers by name, with their sources. wrc_friction_use() sets them: X(identifier, "name", coefficient,
 * WRC_SPEED_LAW_..., kinetic_ratio, fall_rate [s/m], adhesion_reduction, slip_reduction, layer_thickness [m], layer_modulus,
 * layer_yield [Pa], layer_hardening [Pa/m], "source", "how far it is confirmed"). WRC_TANGENTIAL_POLACH alone reads
 * adhesion_reduction and slip_reduction. */
#define WRC_FRICTION_LIST(X)                                                                                                  \
  X(polach_dry, "Polach dry", 0.55, EXPONENTIAL, 0.4, 0.6, 1, 0.4, 0, 0, 0, 0, "Polach, Wear 258 (2005)",                     \
    "quoted from memory, not read again; not compared with his measurements")                                                 \
  X(polach_wet, "Polach wet", 0.3, EXPONENTIAL, 0.4, 0.2, 0.3, 0.1, 0, 0, 0, 0, "Polach, Wear 258 (2005)",                    \
    "quoted from memory, not read again; not compared with his measurements")                                                 \
  X(magnetite, "magnetite", 0.7, NONE, 0.4, 0.6, 1, 1, 20e-6, 176.63e6, 560e6, 0, "Hou, Kalousek, Magel, Wear 211 (1997)",    \
    "numbers of CONTACT's example plastic_3bl, whose creep curves are met; unconfirmed of a rail in service")                 \
  X(clay, "clay", 0.7, NONE, 0.4, 0.6, 1, 1, 20e-6, 106.25e6, 200e6, 4.35e11, "Hou, Kalousek, Magel, Wear 211 (1997)",        \
    "numbers of CONTACT's example plastic_3bl, whose creep curves are met; unconfirmed of a rail in service")                 \
  X(sand, "sand", 0.7, NONE, 0.4, 0.6, 1, 1, 20e-6, 176.63e6, 400e6, -1.95e11, "Hou, Kalousek, Magel, Wear 211 (1997)",       \
    "numbers of CONTACT's example plastic_3bl, whose creep curves are met; unconfirmed of a rail in service")                 \
  X(mos2, "MoS2", 0.7, NONE, 0.4, 0.6, 1, 1, 20e-6, 20.238e6, 20e6, 2.04e10, "Hou, Kalousek, Magel, Wear 211 (1997)",         \
    "numbers of CONTACT's example plastic_3bl, whose creep curves are met; unconfirmed of a rail in service")                 \
  X(locomotive, "locomotive", 0.33, EXPONENTIAL, 0.42424242424242425, 0.5545177444479562, 1, 1, 1.25e-3, 8200e6, 0, 0,        \
    "CONTACT's example tractcurv, second series: a locomotive's measured curve",                                              \
    "its creep curve in CONTACT at 10 m/s is met: 0.31 at 1.6 %, 0.19 at 25 % slip; the measurement was not seen")

#endif /* WRC_METHODS_H */
