! wrc: wheel/rail contact, Fortran 2008 interface to the C library (include_c/wrc/wrc.h has the documentation).
!
! Types have the names and members of the C structs. A variable of any type is zero, its struct_size set; what has other
! defaults gets them from wrc_init:
!     type(wrc_wheel_input) :: input
!     type(wrc_wrench) :: wrench
!     call wrc_init(input)
! Nothing here prints or stops.
! Handles are type(c_ptr). Members of C enums are integer parameters of the same name. What may be NULL in C and is only
! read is a type(c_ptr) too: c_null_ptr, or c_loc of the struct. wrc_interface.inc has them all.
module wrc
  use, intrinsic :: iso_c_binding
  implicit none
  public

  include 'wrc_status.inc'

  include 'wrc_interface.inc'

contains

  include 'wrc_initialisers.inc'

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
  subroutine wrc_contact_last_error(contact, text)
    type(c_ptr), intent(in) :: contact
    character(*), intent(out) :: text
    character(kind=c_char) :: buffer(256)
    integer(c_int32_t) :: status
    status = wrc_contact_last_error_c(contact, buffer, size(buffer, kind=c_int64_t))
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
