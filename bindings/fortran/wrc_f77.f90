! Subroutines for Fortran 77: names of six letters, plain arguments, handles in INTEGER*8. Compile it with module wrc.
!     CALL WRCMOD(IWHEEL, IRAIL, CANT, MODEL, ISTAT)   a model: enum wrc_profile_kind, tangent of the rails' cant
!     CALL WRCCON(MODEL, ISIDE, CONTAC, ISTAT)         a contact of side 0 (right) or 1 (left)
!     CALL WRCSTP(CONTAC, XIN, XOUT, ISTAT)            wrc_contact_step_flat: 8 numbers in, 12 out
!     CALL WRCWHL(CONTAC, XIN, XOUT, ISTAT)            wrc_contact_wrench_flat: 28 numbers in, 18 out
!     CALL WRCTXT(CONTAC, TEXT)                        the sentence behind the last status
!     CALL WRCDEL(CONTAC)                              releases a contact
!     CALL WRCMDE(MODEL)                               releases a model, its contacts before
! ISTAT is a status of wrc_status.h: 0 done, > 0 flagged, < 0 failed.
subroutine wrcmod(iwheel, irail, cant, model, istat)
  use wrc
  implicit none
  integer, intent(in) :: iwheel, irail
  real(c_double), intent(in) :: cant
  integer(c_int64_t), intent(out) :: model
  integer, intent(out) :: istat
  type(wrc_config) :: config
  type(c_ptr) :: made
  call wrc_init(config)
  config%wheel%kind = iwheel
  config%rail%kind = irail
  config%track%rail_inclination = cant
  istat = wrc_model_create(config, c_null_ptr, made)
  model = transfer(made, model)
end subroutine

subroutine wrccon(model, iside, contac, istat)
  use wrc
  implicit none
  integer(c_int64_t), intent(in) :: model
  integer, intent(in) :: iside
  integer(c_int64_t), intent(out) :: contac
  integer, intent(out) :: istat
  type(c_ptr) :: made
  istat = wrc_contact_create(transfer(model, c_null_ptr), iside, c_null_ptr, made)
  contac = transfer(made, contac)
end subroutine

subroutine wrcstp(contac, xin, xout, istat)
  use wrc
  implicit none
  integer(c_int64_t), intent(in) :: contac
  real(c_double), intent(in) :: xin(WRC_FLAT_INPUTS)
  real(c_double), intent(out) :: xout(WRC_FLAT_OUTPUTS)
  integer, intent(out) :: istat
  istat = wrc_contact_step_flat(transfer(contac, c_null_ptr), xin, xout)
end subroutine

subroutine wrcwhl(contac, xin, xout, istat)
  use wrc
  implicit none
  integer(c_int64_t), intent(in) :: contac
  real(c_double), intent(in) :: xin(WRC_FLAT_WHEEL_INPUTS)
  real(c_double), intent(out) :: xout(WRC_FLAT_WHEEL_OUTPUTS)
  integer, intent(out) :: istat
  istat = wrc_contact_wrench_flat(transfer(contac, c_null_ptr), xin, xout)
end subroutine

subroutine wrctxt(contac, text)
  use wrc
  implicit none
  integer(c_int64_t), intent(in) :: contac
  character(*), intent(out) :: text
  call wrc_contact_last_error(transfer(contac, c_null_ptr), text)
end subroutine

subroutine wrcdel(contac)
  use wrc
  implicit none
  integer(c_int64_t), intent(in) :: contac
  call wrc_contact_destroy(transfer(contac, c_null_ptr))
end subroutine

subroutine wrcmde(model)
  use wrc
  implicit none
  integer(c_int64_t), intent(in) :: model
  call wrc_model_destroy(transfer(model, c_null_ptr))
end subroutine
