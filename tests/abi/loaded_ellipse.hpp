/// A contact whose patch is a double ellipse under a load.
#pragma once

#include "reference_contact.hpp"
#include "test_config.hpp"

class LoadedEllipse : public testing::Test {
 protected:
  wrc_config config = test_config();
  wrc_ellipse ellipse = sized<wrc_ellipse>();
  wrc_creepage creepage = wrc_creepage_default();
  wrc_friction friction = wrc_friction_default();
  wrc_planar_forces forces{};
  wrc_model* model = nullptr;
  wrc_contact* contact = nullptr;

  LoadedEllipse() {
    ellipse.a = 6e-3;
    ellipse.b = 4e-3;
    ellipse.normal_force = 80e3;
  }
  void TearDown() override { destroy(); }
  void make() {
    destroy();
    ASSERT_EQ(wrc_model_create(&config, nullptr, &model, nullptr, 0), WRC_OK);
    ASSERT_EQ(wrc_contact_create(model, WRC_SIDE_RIGHT, nullptr, &contact, nullptr, 0), WRC_OK);
  }
  int32_t solve() { return wrc_planar_tangential(contact, &ellipse, &creepage, &friction, &forces); }
  void destroy() {
    wrc_contact_destroy(contact);
    wrc_model_destroy(model);
    contact = nullptr;
    model = nullptr;
  }
};
