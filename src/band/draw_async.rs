//! Bands that are sent by an `async` function.

use core::{
    future::{Future, poll_fn},
    mem::swap,
    pin::{Pin, pin},
    task::Poll,
};

use embedded_graphics_core::{pixelcolor::PixelColor, primitives::Rectangle};

use crate::{
    band::{Band, Bands, FrameError, bands::draw_band},
    framebuffer::Layout,
};

impl<C, L, B, const N: usize> Bands<C, L, B, N>
where
    C: PixelColor,
    L: Layout<C>,
    B: AsRef<[L::Unit]> + AsMut<[L::Unit]>,
{
    /// Draws the frame and sends it, band after band, by an `async` function: in any executor, as embassy.
    ///
    /// With two buffers, sending is started first and the next band is drawn while it runs:
    ///
    /// ```text
    ///   draw    | 0 | 1 |     | 2 |     | 3 |
    ///   send        | 0 ----- | 1 ----- | 2 ----- | 3 ----- |
    /// ```
    ///
    /// Where it is dropped half way, the display has what has been sent; the next frame is complete. Polled again after its end it
    /// panics, as the future of every `async` function does; no executor does that.
    ///
    /// # Errors
    ///
    /// The scene's or the display's, when nothing is being sent any more.
    ///
    /// # Examples
    ///
    /// By `lcd-async`, it is `async |band| display.show_raw_data(x, y, width, height, band.units()).await`. Here the display is a
    /// list:
    ///
    /// ```
    /// use core::{future::Future, pin::pin, task::{Context, Poll, Waker}};
    /// use embedded_graphics::{pixelcolor::Gray8, prelude::*};
    /// use spanfill::{Bands, MsbFirst, Rows, Triangle, prelude::*};
    ///
    /// let mut bands = Bands::<Gray8, Rows<MsbFirst>, _, 2>::new([[0; 64]; 2], Size::new(16, 16), Gray8::BLACK)?;
    /// let mut sent = Vec::new();
    /// let triangle = Triangle::new(Point::new(0, 0), Point::new(15, 3), Point::new(4, 15)).filled(Gray8::WHITE);
    /// let frame = bands.draw_async(
    ///     |band| triangle.draw_on(band),
    ///     async |band| {
    ///         sent.extend_from_slice(band.units());
    ///         Ok::<(), core::convert::Infallible>(())
    ///     },
    /// );
    /// assert_eq!(pin!(frame).poll(&mut Context::from_waker(Waker::noop())), Poll::Ready(Ok(())));
    /// assert_eq!(sent.len(), 256);
    /// # Ok::<(), spanfill::FramebufferError>(())
    /// ```
    pub async fn draw_async<E, F>(
        &mut self,
        scene: impl FnMut(&mut Band<'_, C, L>) -> Result<(), E>,
        flush: impl AsyncFnMut(&Band<'_, C, L>) -> Result<(), F>,
    ) -> Result<(), FrameError<E, F>> {
        self.draw_area_async(&self.screen(), scene, flush).await
    }

    /// The same for a part of the screen.
    ///
    /// # Errors
    ///
    /// As of [`draw_async`](Self::draw_async).
    pub async fn draw_area_async<E, F>(
        &mut self,
        area: &Rectangle,
        mut scene: impl FnMut(&mut Band<'_, C, L>) -> Result<(), E>,
        mut flush: impl AsyncFnMut(&Band<'_, C, L>) -> Result<(), F>,
    ) -> Result<(), FrameError<E, F>> {
        let (mut parts, background) = (self.parts(area), self.background());
        let (front, others) = self.buffers.split_first_mut().ok_or(FrameError::NoBuffer)?;
        let (mut front, mut back) = (front.as_mut(), others.first_mut().map(AsMut::as_mut));
        let Some(part) = parts.next() else { return Ok(()) };
        let mut next = parts.next();
        let mut band = draw_band(&mut *front, &part, background, &mut scene)?;
        loop {
            let (sent, drawn) = {
                let mut sending = pin!(flush(&band));
                let early = poll_once(sending.as_mut()).await;
                let drawn = match (&mut back, &next) {
                    (Some(back), Some(next)) => Some(draw_band(back, next, background, &mut scene).map(drop)),
                    _ => None,
                };
                let sent = match early {
                    Some(sent) => sent,
                    None => sending.await,
                };
                (sent, drawn)
            };
            sent.map_err(FrameError::Flush)?;
            drawn.transpose()?;
            let Some(part) = next else { return Ok(()) };
            next = parts.next();
            band = match &mut back {
                Some(back) => {
                    swap(&mut front, back);
                    Band::new(&mut *front, &part).map_err(|_| FrameError::NoBuffer)?
                }
                None => draw_band(&mut *front, &part, background, &mut scene)?,
            };
        }
    }
}

/// Starts a future: whether it is done at once.
fn poll_once<T>(mut future: Pin<&mut impl Future<Output = T>>) -> impl Future<Output = Option<T>> {
    poll_fn(move |context| {
        Poll::Ready(match future.as_mut().poll(context) {
            Poll::Ready(output) => Some(output),
            Poll::Pending => None,
        })
    })
}
