! wrc_optional: the functions of module wrc under their names without wrc_, in which everything C may be given NULL for is an
! optional argument: of Fortran 2018, where an absent argument is NULL to C. Nothing runs between caller and library.
!     use wrc
!     use wrc_optional
!     status = contact_step(contact, input, output)
!     status = contact_normal(contact, load=load)          ! the gap in the contact, no result wanted
! Handles stay type(c_ptr).
module wrc_optional
  use, intrinsic :: iso_c_binding
  use wrc
  implicit none
  private :: c_ptr, c_funptr, c_int32_t, c_int64_t, c_double, c_char

  include 'wrc_optional.inc'

end module wrc_optional
