//! Enumerations and flags have the numbers of include/mimo, and print their names.
use mimo::{Hearing, Kind, Look, Quantity, Status, Touch};

/// The bits are FORCE 1, SLIP 4 and RA 32 (agent.h).
#[test]
fn flags_combine_and_print() {
    let mut flags = Touch::FORCE | Touch::SLIP;
    assert_eq!((flags.raw(), Touch::empty().raw()), (5, 0));
    assert!(flags.contains(Touch::SLIP) && !flags.contains(Touch::RA) && flags.contains(Touch::empty()));
    flags |= Touch::RA;
    assert_eq!(flags, Touch::from_raw(37));
    assert_eq!(format!("{:?}", flags), "Touch(FORCE | SLIP | RA)");
    assert_eq!(format!("{:?} {:?}", Hearing::empty(), Hearing::EARS), "Hearing(0x0) Hearing(EARS)");
}

/// A newer library may have values and bits that this crate has no name for.
#[test]
fn unknown_numbers_are_kept() {
    let newer = Touch::from_raw(0x4000_0000) | Touch::FORCE;
    assert_eq!((newer.raw(), format!("{:?}", newer).as_str()), (0x4000_0001, "Touch(FORCE | 0x40000000)"));
    assert_eq!((Look::from_raw(99).raw(), format!("{:?}", Look::from_raw(99)).as_str()), (99, "Look(99)"));
    assert_ne!(Look::from_raw(99), Look::HEAD);
}

/// MIMO_E_BUSY is -15 (status.h), bodies are kind 1, and MIMO_NOW is the bit 30 (access.h).
#[test]
fn values_have_the_numbers_of_c() {
    assert_eq!((Status::OK.raw(), Status::BUSY.raw(), Kind::BODY.raw()), (0, -15, 1));
    assert_eq!(format!("{:?} {}", Status::BUSY, Status::BUSY), "BUSY MIMO_E_BUSY");
    assert_eq!(Quantity::BODY_POSITION.now().raw(), Quantity::BODY_POSITION.raw() | 1 << 30);
}
