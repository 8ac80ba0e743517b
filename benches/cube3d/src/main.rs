//! The scene of `examples/cube3d`, drawn by this crate and by its peers from the same triangles on the screen; and the same
//! surface in triangles and in splats.
//!
//! ```text
//! cargo run --release --manifest-path benches/cube3d/Cargo.toml -- peers docs/cube3d-peers.png
//! cargo run --release --manifest-path benches/cube3d/Cargo.toml -- splats docs/charts/triangles-splats.svg
//! ```

mod chart;
mod embedded_3dgfx;
mod frame;
mod ours;
mod peers;
mod retrofire;
#[allow(dead_code, reason = "its own way to draw a frame")]
#[path = "../../../examples/cube3d/scene.rs"]
mod scene;
mod surface;

#[path = "../../../examples/splats/builder.rs"]
mod builder;
#[path = "../../../examples/splats/cloud.rs"]
mod cloud;

use std::path::PathBuf;

use clap::{Parser, Subcommand};

#[derive(Parser)]
#[command(about = "One scene drawn by several libraries; triangles against splats")]
struct Cli {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Draws the scene by each library, prints the rates, and saves the pictures beside each other
    Peers {
        /// The PNG to write
        picture: PathBuf,
        /// How often the 96 frames are drawn; the fastest counts
        #[arg(long, default_value_t = 15)]
        repeat: u32,
    },
    /// Draws one surface of more and more points in triangles and in splats, prints the times, and saves a chart
    Splats {
        /// The SVG to write
        chart: PathBuf,
        /// How often each is drawn; the fastest counts
        #[arg(long, default_value_t = 7)]
        repeat: u32,
    },
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    match Cli::parse().command {
        Command::Peers { picture, repeat } => peers::compare(&picture, repeat),
        Command::Splats { chart, repeat } => surface::compare(&chart, repeat),
    }
}
