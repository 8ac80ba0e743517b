//! By libFuzzer: `cargo fuzz run areas`. Without it, the same by `cargo run --release -- --target areas`.
#![cfg_attr(fuzzing, no_main)]

#[cfg(fuzzing)]
libfuzzer_sys::fuzz_target!(|data: &[u8]| spanfill_fuzz::Target::Areas.run(data));

#[cfg(not(fuzzing))]
fn main() {
    eprintln!("for cargo-fuzz; without it: cargo run --release --manifest-path fuzz/Cargo.toml -- --target areas");
}
