//! The structs have the same layout as in C: sizes and offsets come from interface/generate.py, which
//! reads the header.
use mimo_sys::*;
use std::mem::{size_of, MaybeUninit};

fn size_behind<T>(_: *const T) -> usize {
    size_of::<T>()
}

/// Adds each wrong size of a struct, and each wrong offset or size of a member, to a list.
macro_rules! compare {
    ($wrong:ident, $type:ident $size:literal { $($member:ident $offset:literal $bytes:literal),* $(,)? }) => {{
        let empty = MaybeUninit::<$type>::uninit();
        let start = empty.as_ptr();
        if size_of::<$type>() != $size {
            $wrong.push(stringify!($type).to_string());
        }
        $(
            // This takes an address and reads nothing.
            let member = unsafe { std::ptr::addr_of!((*start).$member) };
            if (member as usize - start as usize, size_behind(member)) != ($offset, $bytes) {
                $wrong.push(concat!(stringify!($type), ".", stringify!($member)).to_string());
            }
        )*
    }};
}

#[test]
fn structs_have_the_layout_of_c() {
    let mut wrong = Vec::<String>::new();
    include!("structs.in");
    assert!(wrong.is_empty(), "not as in C: {:?}", wrong);
}

#[test]
fn library_is_of_this_version() {
    assert_eq!(MIMO_ABI_VERSION, unsafe { mimo_abi_version() });
    assert_eq!(MIMO_API_VERSION, unsafe { mimo_api_version() });
}
