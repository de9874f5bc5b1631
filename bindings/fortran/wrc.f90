! wrc: wheel/rail contact, Fortran 2008 interface to the C library (include_c/wrc/wrc.h has the documentation).
!
! Types have the names and members of the C structs. A variable of any type is zero, its struct_size set; wrc_init gives the
! defaults of any type, also to one that was used before:
!     type(wrc_wheel_input) :: input
!     type(wrc_wrench) :: wrench
!     call wrc_init(input)
! Nothing here prints or stops.
! Handles are type(c_ptr). Members of C enums are integer parameters of the same name; they count from 0 where arrays count
! from 1, and C's rows are Fortran's last index: by%wrench(WRC_BY_Z + 1, 3) is the vertical force by z.
! A rotation matrix R(3, 3): call wrc_set_rotation(input%wheel, R).
!
! What may be NULL in C and is only read is a type(c_ptr): c_null_ptr, or c_loc of the struct. Module wrc_optional has the same
! names with optional arguments in its place; a program uses one of the two. The .inc files have them all.

! What modules wrc and wrc_optional have in common: parameters, types, functions that need all their arguments.
module wrc_common
  use, intrinsic :: iso_c_binding
  implicit none
  public
  private :: from_c

  include 'wrc_status.inc'

  include 'wrc_interface.inc'

contains

  include 'wrc_initialisers.inc'

  ! Says whether a model can be made of `config`, and if not why.
  function wrc_config_check(config, text) result(status)
    type(wrc_config), intent(in) :: config
    character(*), intent(out) :: text
    integer(c_int32_t) :: status
    character(kind=c_char) :: buffer(512)
    status = wrc_config_check_c(config, buffer, size(buffer, kind=c_int64_t))
    call from_c(buffer, text)
  end function

  ! Makes a model; `text` says why not. wrc_model_create_c takes an allocator, too.
  function wrc_model_create(config, model, text) result(status)
    type(wrc_config), intent(in) :: config
    type(c_ptr), intent(out) :: model
    character(*), intent(out) :: text
    integer(c_int32_t) :: status
    character(kind=c_char) :: buffer(512)
    status = wrc_model_create_c(config, c_null_ptr, model, buffer, size(buffer, kind=c_int64_t))
    call from_c(buffer, text)
  end function

  ! Makes a contact; `text` says why not. wrc_contact_create_c takes an allocator, too.
  function wrc_contact_create(model, side, contact, text) result(status)
    type(c_ptr), intent(in) :: model
    integer(c_int32_t), intent(in) :: side
    type(c_ptr), intent(out) :: contact
    character(*), intent(out) :: text
    integer(c_int32_t) :: status
    character(kind=c_char) :: buffer(512)
    status = wrc_contact_create_c(model, side, c_null_ptr, contact, buffer, size(buffer, kind=c_int64_t))
    call from_c(buffer, text)
  end function

  ! The sentence behind the last status other than WRC_OK on this contact.
  subroutine wrc_contact_last_error(contact, text)
    type(c_ptr), intent(in) :: contact
    character(*), intent(out) :: text
    character(kind=c_char) :: buffer(512)
    integer(c_int32_t) :: status
    status = wrc_contact_last_error_c(contact, buffer, size(buffer, kind=c_int64_t))
    call from_c(buffer, text)
    if (status /= WRC_OK) text = 'no contact'
  end subroutine

  ! Gives a wheel its orientation by a matrix, track = matmul(R, body), pitch in it or not; its roll and yaw must be 0.
  subroutine wrc_set_rotation(wheel, R)
    type(wrc_wheel_state), intent(inout) :: wheel
    real(c_double), intent(in) :: R(3, 3)
    wheel%orientation = WRC_ORIENTATION_COLUMNS
    wheel%rotation = reshape(R, [9])
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

end module wrc_common

module wrc
  use wrc_common
  implicit none

  include 'wrc_pointers.inc'

end module wrc
