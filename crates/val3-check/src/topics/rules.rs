//! Pages of rules.

use std::fmt::Write as _;

use val3_lang::page;

use super::options;
use super::topic::{Topic, TopicKind};
use crate::fix::{FixSafety, Offer, fix_offer};
use crate::rule::Rule;
use crate::rules;
use crate::suppression::can_be_silenced;

/// Pages of all rules.
pub(super) fn topics() -> Vec<Topic> {
    rules::all().iter().map(|rule| topic(rule)).collect()
}

fn topic(rule: &Rule) -> Topic {
    let off = if rule.on { "" } else { ", off until configured" };
    let title = format!("# {} {} ({}{off})", rule.code, rule.name, rule.severity.word());
    Topic {
        kind: TopicKind::Finding,
        group: family(rule),
        names: vec![rule.code.to_owned(), rule.name.to_owned()],
        stem: rule.code.to_owned(),
        title: format!("{} {}", rule.code, rule.name),
        summary: page::summary(rule.page),
        page: format!("{title}\n\n{}\n## Fix\n{}\n\n## Settings\n{}", page::text(rule.page), fix(rule), settings(rule)),
    }
}

/// Heading of the family that the first digit of the code names.
fn family(rule: &Rule) -> &'static str {
    match rule.code.as_bytes().get(1..3) {
        Some(b"00") => "Syntax",
        Some(b"01") => "Names",
        Some(b"02") => "Types",
        Some(b"03") => "Flow",
        Some(b"04") => "Motion",
        Some(b"05") => "Projects and data",
        Some(b"06") => "Libraries",
        _ => "Style",
    }
}

/// States whether `--fix` corrects the finding.
fn fix(rule: &Rule) -> String {
    let Some(Offer { every, safety }) = fix_offer(rule) else {
        return "There is no automatic fix.".to_owned();
    };
    let often = if every { "Every finding has a fix" } else { "Some findings have a fix" };
    match safety {
        FixSafety::Safe => format!("{often}. It is safe: `val3 check --fix` applies it."),
        FixSafety::Unsafe => format!("{often}. It is a guess: only `val3 check --fix --unsafe-fixes` applies it."),
        FixSafety::Either => format!(
            "{often}. `val3 check --fix` applies it where it is safe, `val3 check --fix --unsafe-fixes` also where it is a \
             guess."
        ),
    }
}

/// Describes the level and how to change it, the options, and the comment that silences a finding.
fn settings(rule: &Rule) -> String {
    let level = rule.severity.word();
    let (default, change) = match rule.on {
        true => (format!("The level is {level}."), format!("`{} = \"off\"` turns the rule off", rule.name)),
        false => ("The rule is off by default.".to_owned(), format!("`{} = \"on\"` reports it as {level}", rule.name)),
    };
    let mut text = format!(
        "{default} In `val3.toml`, below `[rules]`, {change}; `\"info\"`, `\"warning\"` and `\"error\"` change the level."
    );
    let options: Vec<String> = options::of_rule(rule).map(|option| format!("`{option}`")).collect();
    if !options.is_empty() {
        let _ = write!(text, " Options below `[lint]`: {}.", options.join(", "));
    }
    let _ = match can_be_silenced(rule) {
        true => writeln!(
            text,
            " In code, the comment `//val3: allow({})` in the line before silences one finding.",
            rule.code
        ),
        false => writeln!(text, " No comment silences it."),
    };
    text
}
