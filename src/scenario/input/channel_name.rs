//! Channels by their names.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};

use crate::analysis::Channel;
use crate::rotor::{FREEDOMS, Freedoms};
use crate::scenario::Issue;
use crate::scenario::problems::Problems;

/// A channel of one freedom.
pub type OfFreedom = fn(usize) -> Channel;

/// Words for the same quantity of every freedom that moves.
pub const GROUPS: [(&str, OfFreedom); 4] = [
    ("displacement", Channel::Displacement),
    ("velocity", Channel::Velocity),
    ("acceleration", Channel::Acceleration),
    ("force", Channel::Force),
];

/// The name of a channel or of a group of channels.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct ChannelName(String);

impl AsRef<str> for ChannelName {
    fn as_ref(&self) -> &str {
        &self.0
    }
}

impl JsonSchema for ChannelName {
    fn schema_name() -> Cow<'static, str> {
        "channel".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let groups = GROUPS.iter().map(|(name, _)| *name);
        let listed = every_channel().filter(|channel| !channel.is_further());
        let names: Vec<_> = groups.chain(listed.map(Channel::name)).collect();
        json_schema!({
            "description":
                "A channel, named as in the columns of the trace, or a group of channels.",
            "type": "string",
            "oneOf": [{ "enum": names }, Channel::further_schema()],
        })
    }
}

/// The channels of all freedoms, each kind together, of all housings, bearings and elements.
pub fn every_channel() -> impl Iterator<Item = Channel> {
    let freedoms = GROUPS.iter().flat_map(|(_, of)| (0..FREEDOMS).map(of));
    let of_parts =
        |channel: &Channel| matches!(channel, Channel::Body { .. } | Channel::PartForce { .. });
    freedoms.chain(Channel::all().filter(of_parts))
}

/// Refuses the motion of a freedom that is held; its force is as good as any.
pub fn refuse_held(path: &str, channel: Channel, freedoms: Freedoms, problems: &mut Problems<'_>) {
    let freedom = channel.freedom();
    let is_held = freedom.is_some_and(|freedom| !freedoms.moves(freedom));
    if is_held && !matches!(channel, Channel::Force(_)) {
        let message = format!("`{channel}` does not move: the shaft's `freedoms` hold it");
        let issue =
            Issue::new(path, message).help("leave it out, or set more freedoms in `[shaft]`");
        problems.refuse(issue.against("shaft.freedoms"));
    }
}

/// Refuses a whirl of anything but neighbouring pairs.
pub fn refuse_single(channels: &[Channel], problems: &mut Problems<'_>) {
    let is_pair = |pair: &[Channel]| match pair {
        [x, y] => x.across() == Some(*y),
        _ => false,
    };
    if let Some(wrong) = channels.chunks(2).find(|pair| !is_pair(pair)) {
        let names: Vec<_> = wrong.iter().map(|channel| format!("`{channel}`")).collect();
        let names = names.join(" and ");
        let message = format!("a whirl takes pairs of the x and y of one quantity, not {names}");
        let issue = Issue::new(".channels", message)
            .help("for instance: channels = [\"x\", \"y\"], or [\"force\"]");
        problems.refuse(issue.against(".kind"));
    }
}
