//! The structs lie in memory as tests/abi/layout.json says, which the C compiler's own layout is compared with too.
use mimo_sys::*;
use std::collections::BTreeMap;

/// "struct.field" -> offset and size; "struct" -> 0 and size.
type Layout = BTreeMap<String, (usize, usize)>;

macro_rules! add {
    ($layout:ident, $type:ident { $($field:ident),* $(,)? }) => {{
        let empty = std::mem::MaybeUninit::<$type>::uninit();
        let start = empty.as_ptr();
        $layout.insert(stringify!($type).to_string(), (0, std::mem::size_of::<$type>()));
        $(
            // Only addresses are taken; nothing is read.
            let field = unsafe { std::ptr::addr_of!((*start).$field) };
            // What C may call "type" is "type_" here.
            $layout.insert(
                format!("{}.{}", stringify!($type), stringify!($field).trim_end_matches('_')),
                (field as usize - start as usize, size_of_pointee(field)),
            );
        )*
    }};
}

fn size_of_pointee<T>(_: *const T) -> usize {
    std::mem::size_of::<T>()
}

fn compiled() -> Layout {
    let mut layout = Layout::new();
    include!("structs.in");
    layout
}

/// Reads the list. It has one entry a line: `"name": {`, `"size": 8,` or `"field": [0, 4],`.
fn listed() -> Layout {
    let text =
        std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../../../tests/abi/layout.json"))
            .unwrap();
    let mut layout = Layout::new();
    let mut current = String::new();
    for line in text.lines() {
        let name = line.split('"').nth(1).unwrap_or_default();
        let numbers: Vec<usize> = line
            .rsplit(':')
            .next()
            .unwrap()
            .split(|c: char| !c.is_ascii_digit())
            .filter_map(|digits| digits.parse().ok())
            .collect();
        match numbers[..] {
            [] if line.ends_with('{') && !name.is_empty() => current = name.to_string(),
            [size] => {
                layout.insert(current.clone(), (0, size));
            }
            [offset, size] => {
                layout.insert(format!("{}.{}", current, name), (offset, size));
            }
            _ => {}
        }
    }
    layout
}

#[test]
fn structs_lie_as_listed() {
    let (listed, compiled) = (listed(), compiled());
    assert!(listed.len() > 100);
    let names = listed.keys().chain(compiled.keys());
    let wrong: Vec<_> = names.filter(|&name| listed.get(name) != compiled.get(name)).collect();
    assert!(wrong.is_empty(), "not as in tests/abi/layout.json: {:?}", wrong);
}

#[test]
fn library_is_of_this_version() {
    assert_eq!(MIMO_ABI_VERSION, unsafe { mimo_abi_version() });
    assert_eq!(MIMO_API_VERSION, unsafe { mimo_api_version() });
}
