//! The media as instructions reach them.

use val3_lang::ports::Media;

use super::Devices;

impl Media for Devices {}
