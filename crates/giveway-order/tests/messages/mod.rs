//! VDA 5050 messages beside the published schemas.

use giveway_model::Instance;
use giveway_order::{Order, Vda5050, vda5050};
use jsonschema::Validator;
use serde_json::{Value, json};

/// The messages of an order.
pub(crate) fn messages(instance: &Instance, order: &Order) -> Vda5050 {
    let units = instance.to_scene().units;
    vda5050(order, instance.name(), instance.grid().height(), units)
}

/// The published schemas of an order, 2.1.0 and 3.0.0.
pub(crate) struct Schemas([Validator; 2]);

impl Schemas {
    pub(crate) fn published() -> Self {
        let schemas = [
            include_str!("../data/vda5050-2.1.0-order.schema.json"),
            include_str!("../data/vda5050-3.0.0-order.schema.json"),
        ];
        Self(schemas.map(|schema| {
            let schema: Value = serde_json::from_str(schema).unwrap();
            let options = jsonschema::options().should_validate_formats(true);
            options.build(&schema).unwrap()
        }))
    }

    /// Every message is valid by both, and one with a word for a truth value is not.
    pub(crate) fn accept(&self, messages: &Vda5050) {
        for validator in &self.0 {
            let updates = messages.updates.iter().map(|it| &it.order);
            for message in messages.orders.iter().chain(updates) {
                let errors = validator.iter_errors(message);
                let errors: Vec<String> = errors.map(|it| it.to_string()).collect();
                assert!(errors.is_empty(), "{errors:?}: {message}");
            }
            let mut wrong = messages.orders[0].clone();
            wrong["nodes"][0]["released"] = json!("yes");
            assert!(!validator.is_valid(&wrong));
        }
    }
}
