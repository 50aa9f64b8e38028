//! Names of channels: written, read, and in schemas.

use std::borrow::Cow;
use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

use super::{Channel, Part};
use crate::rotor::Body;

/// Names of the forces of elements, and of the bearings and the resonators behind the first, as a regular expression.
const FURTHER: &str = "^((bearing([2-9]|[1-5][0-9]|6[0-4])|element([1-9]|[1-5][0-9]|6[0-4]))_(force_[xyz]|moment_[xy])|\
                       resonator[2-4]_[xyz](_velocity|_acceleration)?)$";

impl Channel {
    /// The columns that a trace can show besides the time, in the order in which the tables show them.
    pub(crate) fn selectable() -> impl Iterator<Item = Self> {
        let beside =
            |channel: &Self| !matches!(channel, Self::Time | Self::Energy(_) | Self::Drive(_));
        Self::all().filter(beside)
    }

    /// Whether lists of names leave it out, as what bearings behind the first have like it.
    pub fn is_further(self) -> bool {
        let resonators = matches!(
            self,
            Self::Body {
                body: Body::Resonator(1..),
                ..
            }
        );
        let parts = matches!(
            self,
            Self::PartForce {
                part: Part::Bearing(1..) | Part::Element(_),
                ..
            }
        );
        resonators || parts
    }

    /// Schema of the names that lists leave out.
    pub(crate) fn further_schema() -> Schema {
        json_schema!({
            "description": "The same of bearing 2, 3, … or of element 1, 2, … in place of bearing 1.",
            "type": "string",
            "pattern": FURTHER,
        })
    }

    /// Name and unit as a value of a result.
    pub(crate) fn serialize_with_unit<S: Serializer>(
        &self,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        self.column().serialize(serializer)
    }
}

/// The name.
impl fmt::Display for Channel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.name())
    }
}

/// The name.
impl Serialize for Channel {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

/// By the name, of those that a trace can show.
impl<'de> Deserialize<'de> for Channel {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = Cow::<str>::deserialize(deserializer)?;
        let found = Self::selectable().find(|channel| channel.name() == name);
        found.ok_or_else(|| {
            let names = Self::selectable().filter(|one| !one.is_further());
            let names: Vec<_> = names.map(|one| format!("`{one}`")).collect();
            let names = names.join(", ");
            de::Error::custom(format!("unknown variant `{name}`, expected one of {names}"))
        })
    }
}

impl JsonSchema for Channel {
    fn inline_schema() -> bool {
        true
    }

    fn schema_name() -> Cow<'static, str> {
        "column".into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let listed = Self::selectable().filter(|channel| !channel.is_further());
        let column = |channel: Self| {
            let description = match channel.unit() {
                "" => "A number.".to_owned(),
                unit => format!("In {unit}."),
            };
            json_schema!({ "description": description, "type": "string", "const": channel.name() })
        };
        json_schema!({
            "description": "A column of the trace besides the time.",
            "oneOf": listed.map(column).chain([Self::further_schema()]).collect::<Vec<_>>(),
        })
    }
}
