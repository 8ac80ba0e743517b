//! Pictures to draw on, which are too large for a test's stack: a few, for tests that run beside each other.

use std::sync::{Mutex, MutexGuard, TryLockError};

use crate::variants::Picture;

static PICTURES: [Mutex<Picture>; 4] = [const { Mutex::new(Picture::new()) }; 4];

/// One that nobody draws on; where there is none, the first when it is free.
pub(crate) fn picture() -> MutexGuard<'static, Picture> {
    let [first, ..] = &PICTURES;
    let free = PICTURES.iter().find_map(|picture| match picture.try_lock() {
        Ok(free) => Some(free),
        Err(TryLockError::Poisoned(poisoned)) => Some(emptied(picture, poisoned.into_inner())),
        Err(TryLockError::WouldBlock) => None,
    });
    free.unwrap_or_else(|| first.lock().unwrap_or_else(|poisoned| emptied(first, poisoned.into_inner())))
}

/// Without what a test left behind that failed.
fn emptied<'p>(picture: &'p Mutex<Picture>, mut held: MutexGuard<'p, Picture>) -> MutexGuard<'p, Picture> {
    picture.clear_poison();
    *held = Picture::new();
    held
}
