//! Tests of the public interface: types of expressions, faults of all kinds of files, interfaces, incrementality.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic, clippy::indexing_slicing, reason = "tests")]

mod show;

mod application;
mod arguments;
mod attributes;
mod calls;
mod configuration;
mod data;
mod dialect;
mod discovery;
mod expressions;
mod fathers;
mod fields;
mod firewall;
mod flow;
mod headers;
mod hostile;
mod initial;
mod interfaces;
mod literals;
mod names;
mod operators;
mod projects;
mod silence;
mod surroundings;
mod variables;
mod waiting;
