// Long patterns of Rust, for rust.toml. Marks: language_file.h.

// @text tables.index_helper
// An index outside of its table reads the nearest element.
fn table_index(index: $real, extent: usize) -> usize {
    if !(index > 0.0) { return 0; }
    if index < extent as $real { index as usize } else { extent - 1 }
}

// @text externals.bridge.structure
    #[repr(C)]
    pub struct Numbers$count {
        pub m: [f64; $count],
    }


// @text externals.bridge.begin
/// Functions of the program's libraries, with structs as what they consist of.
mod library {
    use std::os::raw::*;


// @text externals.bridge.declaration
    extern "C" {
        #[link_name = "$c_name"]
        pub fn c_$name($declared)$result;
    }

// @text externals.bridge.bridge
fn $name(a: &[f64], r: &mut [f64]) {
    let _ = (a.len(), r.len());
$copies$stored}


// @text files.hide_helper
// An argument that is constant on some path: a compiler would evaluate the call there, and round
// otherwise than the library.
fn at_run(x: $real) -> $real {
    unsafe { std::ptr::read_volatile(&x) }
}
