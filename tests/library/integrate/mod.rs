//! The methods of integration: on problems of known solution, and on the rotor.

mod exponential;
mod landing;
mod methods;
