//! Pages of instructions.

use val3_lang::instruction::{Availability, Family, Instruction};
use val3_lang::{instructions, page};

use super::topic::{Topic, TopicKind, sourced, stem};

/// Pages of all instructions, grouped by family.
pub(super) fn topics() -> Vec<Topic> {
    let mut rows: Vec<&Instruction> = instructions::all().to_vec();
    rows.sort_by_key(|row| row.family);
    rows.into_iter().map(topic).collect()
}

fn topic(row: &Instruction) -> Topic {
    let forms: String = row.overloads.iter().map(|form| form.signature(row.name) + "\n").collect();
    let title = format!("# {} ({})\n\n```\n{forms}```\n\n", row.name, origin(row));
    Topic {
        kind: TopicKind::Instruction,
        group: heading(row.family),
        names: vec![row.name.to_owned()],
        stem: stem(row.name),
        title: row.name.to_owned(),
        summary: page::summary(row.page),
        page: title + &page::text(row.page),
    }
}

/// Instruction origin: the section of the manual, the version or the add-on.
fn origin(row: &Instruction) -> String {
    match row.availability {
        Availability::Manual => sourced("instruction", row.section),
        Availability::Version { since, until: Some(until) } => format!("instruction, s{since} to s{until}"),
        Availability::Version { since, until: None } => format!("instruction, from s{since} on"),
        Availability::AddOn(name) => format!("instruction of the add-on {name}"),
    }
}

/// Heading of a family, named as in the manual.
fn heading(family: Family) -> &'static str {
    match family {
        Family::Variables => "Variables, arrays, collections",
        Family::Numbers => "Numbers",
        Family::Bits => "Bit fields",
        Family::Strings => "Strings",
        Family::Io => "Inputs, outputs, lines",
        Family::Screen => "User page",
        Family::Tasks => "Tasks",
        Family::Libraries => "Libraries",
        Family::Controller => "Robot control",
        Family::Geometry => "Arm positions",
        Family::Motion => "Motion",
        Family::Options => "Options",
        Family::Additions => "Beyond the manual",
        Family::AddOns => "Add-ons",
    }
}
