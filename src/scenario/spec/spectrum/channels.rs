//! The channels of a `[[spectrum]]`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::{KindChoice, SpectrumSpec};
use crate::analysis::Channel;
use crate::rotor::Freedoms;
use crate::scenario::Issue;
use crate::scenario::problems::Problems;

/// A channel, named as in the columns of the trace, or a group of channels.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[allow(missing_docs)] // each is the channel of its name
pub enum ChannelChoice {
    Displacement,
    Velocity,
    Acceleration,
    Force,
    X,
    Y,
    Z,
    TiltX,
    TiltY,
    XVelocity,
    YVelocity,
    ZVelocity,
    TiltXVelocity,
    TiltYVelocity,
    XAcceleration,
    YAcceleration,
    ZAcceleration,
    TiltXAcceleration,
    TiltYAcceleration,
    ForceX,
    ForceY,
    ForceZ,
    MomentX,
    MomentY,
}

/// What a word stands for.
enum Meaning {
    One(Channel),
    /// The same quantity of every freedom that moves.
    Group(fn(usize) -> Channel),
}

impl ChannelChoice {
    fn meaning(self) -> Meaning {
        use Meaning::{Group, One};
        match self {
            Self::Displacement => Group(Channel::Displacement),
            Self::Velocity => Group(Channel::Velocity),
            Self::Acceleration => Group(Channel::Acceleration),
            Self::Force => Group(Channel::Force),
            Self::X => One(Channel::Displacement(0)),
            Self::Y => One(Channel::Displacement(1)),
            Self::Z => One(Channel::Displacement(2)),
            Self::TiltX => One(Channel::Displacement(3)),
            Self::TiltY => One(Channel::Displacement(4)),
            Self::XVelocity => One(Channel::Velocity(0)),
            Self::YVelocity => One(Channel::Velocity(1)),
            Self::ZVelocity => One(Channel::Velocity(2)),
            Self::TiltXVelocity => One(Channel::Velocity(3)),
            Self::TiltYVelocity => One(Channel::Velocity(4)),
            Self::XAcceleration => One(Channel::Acceleration(0)),
            Self::YAcceleration => One(Channel::Acceleration(1)),
            Self::ZAcceleration => One(Channel::Acceleration(2)),
            Self::TiltXAcceleration => One(Channel::Acceleration(3)),
            Self::TiltYAcceleration => One(Channel::Acceleration(4)),
            Self::ForceX => One(Channel::Force(0)),
            Self::ForceY => One(Channel::Force(1)),
            Self::ForceZ => One(Channel::Force(2)),
            Self::MomentX => One(Channel::Force(3)),
            Self::MomentY => One(Channel::Force(4)),
        }
    }
}

/// Freedoms of a whirl: what turns with the shaft runs from the first to the second.
const WHIRLS: [[usize; 2]; 2] = [[0, 1], [3, 4]];

impl SpectrumSpec {
    /// The channels, each once, in the order of the table.
    pub(super) fn channels(
        &self,
        path: &str,
        freedoms: Freedoms,
        problems: &mut Problems<'_>,
    ) -> Vec<Channel> {
        let mut channels = Vec::new();
        for (index, choice) in self.channels.iter().enumerate() {
            let found = match choice.meaning() {
                Meaning::Group(of) => self.group(freedoms).into_iter().map(of).collect(),
                Meaning::One(channel) => {
                    let path = format!("{path}.channels[{index}]");
                    refuse_held(&path, channel, freedoms, problems);
                    vec![channel]
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
            KindChoice::Whirl => refuse_single(path, &channels, problems),
            KindChoice::Cross => refuse_lone(path, &channels, problems),
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
    if channel.freedom() >= freedoms.count() && !is_force {
        let message = format!("`{channel}` does not move: the shaft's `freedoms` hold it");
        let issue =
            Issue::new(path, message).help("leave it out, or set more freedoms in `[shaft]`");
        problems.refuse(issue, &["shaft.freedoms".to_owned()]);
    }
}

/// Refuses a whirl of anything but neighbouring pairs.
fn refuse_single(path: &str, channels: &[Channel], problems: &mut Problems<'_>) {
    let is_pair = |pair: &[Channel]| match pair {
        [x, y] => {
            let freedoms = [x.freedom(), y.freedom()];
            let same = std::mem::discriminant(x) == std::mem::discriminant(y);
            same && WHIRLS.contains(&freedoms)
        }
        _ => false,
    };
    if let Some(wrong) = channels.chunks(2).find(|pair| !is_pair(pair)) {
        let names: Vec<_> = wrong.iter().map(|channel| format!("`{channel}`")).collect();
        let message = format!(
            "a whirl takes pairs of the x and y of one quantity, not {}",
            names.join(" and ")
        );
        let issue = Issue::new(format!("{path}.channels"), message)
            .help("for instance: channels = [\"x\", \"y\"], or [\"force\"]");
        problems.refuse(issue, &[format!("{path}.kind")]);
    }
}

/// Refuses a cross spectrum of one channel.
fn refuse_lone(path: &str, channels: &[Channel], problems: &mut Problems<'_>) {
    if channels.len() < 2 {
        let message = "a cross spectrum takes two channels or more: the first is the reference";
        let issue = Issue::new(format!("{path}.channels"), message)
            .help("for instance: channels = [\"force_x\", \"x\"]");
        problems.refuse(issue, &[format!("{path}.kind")]);
    }
}
