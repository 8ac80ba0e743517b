//! Bands that are sent by transfers which own their memory.

use embedded_graphics_core::{pixelcolor::PixelColor, primitives::Rectangle};

use crate::{
    band::{Band, Bands, FrameError, bands::draw_band},
    framebuffer::Layout,
};

/// What starts transfers to a display: the bus, the DMA channel and whatever else it takes, all of which it owns.
///
/// `B` is the buffer, as a `&'static mut [u8]`.
pub trait Transmit<B>: Sized {
    /// A transfer that runs.
    type Transfer: Transfer<B, Sender = Self>;

    /// Starts to send the first `length` units of a buffer, the pixels of `area` row by row. What goes wrong, the transfer tells
    /// when it is waited for.
    fn start(self, area: &Rectangle, buffer: B, length: usize) -> Self::Transfer;
}

/// A transfer that runs: the owner of its sender and of the buffer, until it is done.
///
/// As it owns them, nothing else can reach the memory that is being sent. One that is forgotten keeps both for ever, and
/// nothing else happens.
pub trait Transfer<B> {
    /// What started it.
    type Sender;

    /// What can go wrong.
    type Error;

    /// Waits for its end and gives back what it owns, whatever went wrong.
    fn wait(self) -> (Self::Sender, B, Result<(), Self::Error>);
}

/// The error of what `T` starts.
type ErrorOf<T, B> = <<T as Transmit<B>>::Transfer as Transfer<B>>::Error;

/// The sender, and how the frame went.
type Ended<T, B, E> = (T, Result<(), FrameError<E, ErrorOf<T, B>>>);

impl<C, L, B, const N: usize> Bands<C, L, B, N>
where
    C: PixelColor,
    L: Layout<C>,
    B: AsRef<[L::Unit]> + AsMut<[L::Unit]>,
{
    /// Draws the frame and sends it, band after band, by transfers that own the buffer meanwhile, as DMA needs it. With two
    /// buffers, the next band is drawn while one is being sent.
    ///
    /// Gives the sender back when nothing is being sent any more.
    ///
    /// # Errors
    ///
    /// The scene's or the display's; what has been sent remains on the display, every buffer comes back, and the next frame is
    /// complete.
    #[inline]
    pub fn draw_by_transfers<E, T: Transmit<B>>(
        &mut self,
        sender: T,
        scene: impl FnMut(&mut Band<'_, C, L>) -> Result<(), E>,
    ) -> Ended<T, B, E> {
        self.draw_area_by_transfers(&self.screen(), sender, scene)
    }

    /// The same for a part of the screen.
    ///
    /// # Errors
    ///
    /// As of [`draw_by_transfers`](Self::draw_by_transfers).
    pub fn draw_area_by_transfers<E, T: Transmit<B>>(
        &mut self,
        area: &Rectangle,
        sender: T,
        mut scene: impl FnMut(&mut Band<'_, C, L>) -> Result<(), E>,
    ) -> Ended<T, B, E> {
        let mut line = Line::Idle(sender);
        for part in self.parts(area) {
            // With a single buffer, the last transfer has it.
            if self.buffers.is_empty() {
                let (sender, sent) = line.wait(self);
                line = Line::Idle(sender);
                if sent.is_err() {
                    return line.end(self, sent);
                }
            }
            let Some(mut buffer) = self.buffers.pop() else { return line.end(self, Err(FrameError::NoBuffer)) };
            let drawn = draw_band(buffer.as_mut(), &part, self.background(), &mut scene).map(|band| band.units().len());
            let (sender, sent) = line.wait(self);
            match sent.and(drawn) {
                Ok(length) => line = Line::Sending(sender.start(&part, buffer, length)),
                Err(error) => {
                    self.keep(buffer);
                    return (sender, Err(error));
                }
            }
        }
        line.end(self, Ok(()))
    }

    /// There is room for what was taken out.
    fn keep(&mut self, buffer: B) {
        drop(self.buffers.push(buffer));
    }
}

/// What the sender does.
enum Line<B, T: Transmit<B>> {
    Idle(T),
    Sending(T::Transfer),
}

impl<B, T: Transmit<B>> Line<B, T> {
    /// Waits until nothing is being sent, and puts the buffer back that was.
    fn wait<C, L, E, const N: usize>(self, bands: &mut Bands<C, L, B, N>) -> Ended<T, B, E>
    where
        C: PixelColor,
        L: Layout<C>,
        B: AsRef<[L::Unit]> + AsMut<[L::Unit]>,
    {
        match self {
            Self::Idle(sender) => (sender, Ok(())),
            Self::Sending(transfer) => {
                let (sender, buffer, sent) = transfer.wait();
                bands.keep(buffer);
                (sender, sent.map_err(FrameError::Flush))
            }
        }
    }

    /// The frame's end, and how it went before what is still being sent.
    fn end<C, L, E, const N: usize>(
        self,
        bands: &mut Bands<C, L, B, N>,
        before: Result<(), FrameError<E, ErrorOf<T, B>>>,
    ) -> Ended<T, B, E>
    where
        C: PixelColor,
        L: Layout<C>,
        B: AsRef<[L::Unit]> + AsMut<[L::Unit]>,
    {
        let (sender, sent) = self.wait(bands);
        (sender, before.and(sent))
    }
}
