//! Enumerations: numbers with named constants. They are open, as in C, because a newer library may return and
//! accept values that this crate has no name for.

/// A choice of one value.
macro_rules! values {
    ($(#[$about:meta])* $name:ident: $number:ident $($(#[$what:meta])* $value:ident = $constant:ident,)*) => {
        $(#[$about])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
        #[repr(transparent)]
        pub struct $name($number);

        impl $name {
            $($(#[$what])* pub const $value: $name = $name(sys::$constant);)*

            /// The value that has this number in C.
            pub const fn from_raw(number: $number) -> $name {
                $name(number)
            }

            /// Its number in C.
            pub const fn raw(self) -> $number {
                self.0
            }
        }

        impl std::fmt::Debug for $name {
            fn fmt(&self, out: &mut std::fmt::Formatter) -> std::fmt::Result {
                $(if self.0 == sys::$constant {
                    return out.write_str(stringify!($value));
                })*
                write!(out, "{}({})", stringify!($name), self.0)
            }
        }
    };
}

/// A set of flags, combined by `|`.
macro_rules! flags {
    ($(#[$about:meta])* $name:ident: $number:ident $($(#[$what:meta])* $flag:ident = $constant:ident,)*) => {
        $(#[$about])*
        #[derive(Clone, Copy, Default, PartialEq, Eq, Hash)]
        #[repr(transparent)]
        pub struct $name($number);

        impl $name {
            $($(#[$what])* pub const $flag: $name = $name(sys::$constant);)*

            /// No flag.
            pub const fn empty() -> $name {
                $name(0)
            }

            /// The flags that have these bits in C.
            pub const fn from_raw(bits: $number) -> $name {
                $name(bits)
            }

            /// Their bits in C.
            pub const fn raw(self) -> $number {
                self.0
            }

            /// Whether all flags of `other` are set.
            pub const fn contains(self, other: $name) -> bool {
                self.0 & other.0 == other.0
            }
        }

        impl std::ops::BitOr for $name {
            type Output = $name;
            fn bitor(self, other: $name) -> $name {
                $name(self.0 | other.0)
            }
        }

        impl std::ops::BitOrAssign for $name {
            fn bitor_assign(&mut self, other: $name) {
                self.0 |= other.0;
            }
        }

        impl std::fmt::Debug for $name {
            fn fmt(&self, out: &mut std::fmt::Formatter) -> std::fmt::Result {
                let mut names = Vec::new();
                let mut rest = self.0;
                $(if self.0 & sys::$constant != 0 {
                    names.push(stringify!($flag).to_string());
                    rest &= !sys::$constant;
                })*
                if rest != 0 || names.is_empty() {
                    names.push(format!("{:#x}", rest));
                }
                write!(out, "{}({})", stringify!($name), names.join(" | "))
            }
        }
    };
}
