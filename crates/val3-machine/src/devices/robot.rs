//! Power, modes, speed, versions, users and dates as instructions reach them.

use val3_lang::ports::Robot;

use super::Devices;

impl Robot for Devices {}
