// What was typed after Ctrl+K as a search by words in the dataset that is open.
import { addPlaces } from "../shared/places.mjs";

addPlaces((text) => {
  const words = text.trim();
  const dataset = new URLSearchParams(location.search).get("dataset");
  if (words.length < 3 || !dataset) return [];
  const query = new URLSearchParams({ dataset, look: "words", words });
  return [{ name: `Find “${words}” in the motion`, about: "search by words", address: `/search?${query}` }];
});
