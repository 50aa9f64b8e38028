//! The channels of a `[[spectrum]]`.

use std::borrow::Cow;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Serialize};

use super::{KindChoice, SpectrumInput};
use crate::analysis::Channel;
use crate::rotor::{FREEDOMS, Freedoms};
use crate::scenario::Issue;
use crate::scenario::problems::Problems;

/// A channel of one freedom.
type OfFreedom = fn(usize) -> Channel;

/// Words for the same quantity of every freedom that moves.
const GROUPS: [(&str, OfFreedom); 4] = [
    ("displacement", Channel::Displacement),
    ("velocity", Channel::Velocity),
    ("acceleration", Channel::Acceleration),
    ("force", Channel::Force),
];

/// The name of a channel or of a group of channels.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct ChannelName(String);

impl JsonSchema for ChannelName {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "channel".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let groups = GROUPS.iter().map(|(name, _)| *name);
        let names: Vec<_> = groups.chain(every_channel().map(Channel::name)).collect();
        json_schema!({
            "description":
                "A channel, named as in the columns of the trace, or a group of channels.",
            "type": "string",
            "enum": names,
        })
    }
}

/// The channels of all freedoms, each kind together.
fn every_channel() -> impl Iterator<Item = Channel> {
    GROUPS.iter().flat_map(|(_, of)| (0..FREEDOMS).map(of))
}

/// Freedoms of a whirl: what turns with the shaft runs from the first to the second.
const WHIRLS: [(usize, usize); 2] = [(0, 1), (3, 4)];

impl SpectrumInput {
    /// The channels, each once, in the order of the table.
    pub(super) fn channels(&self, freedoms: Freedoms, problems: &mut Problems<'_>) -> Vec<Channel> {
        let mut channels = Vec::new();
        for (index, ChannelName(word)) in self.channels.iter().enumerate() {
            let found = match GROUPS.iter().find(|(name, _)| name == word) {
                Some((_, of)) => self.group(freedoms).into_iter().map(of).collect(),
                None => {
                    let named: Vec<_> = every_channel().filter(|c| c.name() == word).collect();
                    let path = format!(".channels[{index}]");
                    for channel in &named {
                        refuse_held(&path, *channel, freedoms, problems);
                    }
                    named
                }
            };
            for channel in found {
                if !channels.contains(&channel) {
                    channels.push(channel);
                }
            }
        }
        match self.kind {
            KindChoice::Plain | KindChoice::Envelope => {}
            KindChoice::Whirl => refuse_single(&channels, problems),
            KindChoice::Cross => refuse_lone(&channels, problems),
        }
        channels
    }

    /// Freedoms that a group stands for; in a whirl those that turn.
    fn group(&self, freedoms: Freedoms) -> Vec<usize> {
        let moving = 0..freedoms.count();
        match self.kind {
            KindChoice::Whirl => moving.filter(|freedom| *freedom != 2).collect(),
            _ => moving.collect(),
        }
    }
}

/// Refuses the motion of a freedom that is held; its force is as good as any.
fn refuse_held(path: &str, channel: Channel, freedoms: Freedoms, problems: &mut Problems<'_>) {
    let is_force = matches!(channel, Channel::Force(_));
    let is_held = channel
        .freedom()
        .is_some_and(|freedom| freedom >= freedoms.count());
    if is_held && !is_force {
        let message = format!("`{channel}` does not move: the shaft's `freedoms` hold it");
        let issue =
            Issue::new(path, message).help("leave it out, or set more freedoms in `[shaft]`");
        problems.refuse(issue.against("shaft.freedoms"));
    }
}

/// Refuses a whirl of anything but neighbouring pairs.
fn refuse_single(channels: &[Channel], problems: &mut Problems<'_>) {
    let is_pair = |pair: &[Channel]| match pair {
        [x, y] => {
            let freedoms = x.freedom().zip(y.freedom());
            let same = std::mem::discriminant(x) == std::mem::discriminant(y);
            same && freedoms.is_some_and(|freedoms| WHIRLS.contains(&freedoms))
        }
        _ => false,
    };
    if let Some(wrong) = channels.chunks(2).find(|pair| !is_pair(pair)) {
        let names: Vec<_> = wrong.iter().map(|channel| format!("`{channel}`")).collect();
        let message = format!(
            "a whirl takes pairs of the x and y of one quantity, not {}",
            names.join(" and ")
        );
        let issue = Issue::new(".channels", message)
            .help("for instance: channels = [\"x\", \"y\"], or [\"force\"]");
        problems.refuse(issue.against(".kind"));
    }
}

/// Refuses a cross spectrum of one channel.
fn refuse_lone(channels: &[Channel], problems: &mut Problems<'_>) {
    if channels.len() < 2 {
        let message = "a cross spectrum takes two channels or more: the first is the reference";
        let issue =
            Issue::new(".channels", message).help("for instance: channels = [\"force_x\", \"x\"]");
        problems.refuse(issue.against(".kind"));
    }
}
