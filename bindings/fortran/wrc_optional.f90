! wrc_optional: module wrc with optional arguments in place of everything C may be given NULL for, those of Fortran 2018, where an
! absent argument is NULL to C. Nothing runs between caller and library. A program uses this module or wrc.
!     use wrc_optional
!     status = wrc_contact_wrench(contact, input, wrench)
!     status = wrc_contact_wrench_derivatives(contact, input, derivatives=by)   ! the wrench itself is not wanted
!     status = wrc_planar_normal(contact, load=load)                            ! the gap in the contact, no result wanted
! Handles stay type(c_ptr).
module wrc_optional
  use wrc_common
  implicit none

  include 'wrc_optional.inc'

end module wrc_optional
