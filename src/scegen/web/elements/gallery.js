// All logical scenarios as tiles. Only what is near the window is there: thousands stay smooth.
export default {
  template: `
    <div class="gallery" ref="box" tabindex="0" role="listbox" aria-multiselectable="true"
      aria-label="Logical scenarios" @scroll.passive="look" @keydown="key">
      <div class="gallery-all" :style="{ height: height + 'px' }">
        <button v-for="tile in visible" :key="tile.index" class="tile" role="option" tabindex="-1"
          :class="{ picked: places.has(tile.index), near: tile.place === at }" :style="tile.style"
          :aria-selected="places.has(tile.index)" :aria-label="names[tile.index] || 'scenario ' + tile.index"
          @click="toggle(tile, $event)" @dblclick.prevent="$emit('only', tile.index)">
          <span class="tile-order" v-if="places.has(tile.index)">{{ places.get(tile.index) + 1 }}</span>
          <span class="tile-picture" v-html="pictures[tile.index] || ''"></span>
        </button>
      </div>
    </div>`,
  props: { indices: Array, picked: Array, source: String, ratio: Number, edition: Number },
  data() {
    return { pictures: {}, names: {}, top: 0, width: 800, tall: 600, wanted: new Set(), at: -1, timer: null, chosen: this.picked };
  },
  computed: {
    places() {
      return new Map(this.chosen.map((index, place) => [index, place]));
    },
    columns() {
      return Math.max(1, Math.floor((this.width + 10) / 196));
    },
    cell() {
      const width = (this.width - 10 * (this.columns - 1)) / this.columns;
      return { width, height: width * this.ratio };
    },
    row() {
      return this.cell.height + 10;
    },
    height() {
      return Math.ceil(this.indices.length / this.columns) * this.row;
    },
    visible() {
      const first = Math.max(0, Math.floor(this.top / this.row) - 1) * this.columns;
      const last = (Math.ceil((this.top + this.tall) / this.row) + 1) * this.columns;
      return this.indices.slice(first, last).map((index, n) => {
        const place = first + n;
        const x = (place % this.columns) * (this.cell.width + 10);
        const y = Math.floor(place / this.columns) * this.row;
        const style = `transform:translate(${x}px,${y}px);width:${this.cell.width}px;height:${this.cell.height}px`;
        return { index, place, style };
      });
    },
  },
  watch: {
    picked(now) {
      this.chosen = now;
    },
    edition() {
      this.pictures = {};
      this.names = {};
      this.$refs.box.scrollTop = 0;
      this.top = 0;
    },
    visible() {
      clearTimeout(this.timer);
      this.timer = setTimeout(this.fetchMissing, 30);
    },
  },
  mounted() {
    this.observer = new ResizeObserver(this.measure);
    this.observer.observe(this.$refs.box);
    this.measure();
    this.$nextTick(() => this.chosen.length && this.bringIn(this.indices.indexOf(this.chosen[0])));
    this.fetchMissing();
  },
  unmounted() {
    this.observer.disconnect();
    clearTimeout(this.timer);
  },
  methods: {
    measure() {
      const box = this.$refs.box;
      this.width = box.clientWidth - 4;
      this.tall = box.clientHeight;
    },
    look() {
      this.top = this.$refs.box.scrollTop;
    },
    async fetchMissing() {
      const missing = this.visible.map((t) => t.index).filter((i) => !(i in this.pictures) && !this.wanted.has(i));
      if (!missing.length) return;
      missing.forEach((i) => this.wanted.add(i));
      const edition = this.edition;
      try {
        for (let n = 0; n < missing.length; n += 12) {
          const some = missing.slice(n, n + 12);
          const answer = await fetch(`${this.source}?edition=${edition}&of=${some.join(",")}`);
          if (!answer.ok) break;
          const tiles = await answer.json();
          if (edition !== this.edition) return;
          for (const tile of tiles) {
            this.pictures[tile.index] = tile.svg;
            this.names[tile.index] = tile.name;
          }
        }
      } finally {
        missing.forEach((i) => this.wanted.delete(i));
      }
    },
    bringIn(place) {
      const y = Math.floor(place / this.columns) * this.row;
      const box = this.$refs.box;
      if (y < box.scrollTop || y + this.row > box.scrollTop + this.tall) box.scrollTop = y - this.tall / 3;
    },
    toggle(tile, event) {
      if (event.shiftKey && this.at >= 0) {
        const [from, to] = [Math.min(this.at, tile.place), Math.max(this.at, tile.place)];
        this.$emit("pick", { add: this.indices.slice(from, to + 1) });
      } else {
        this.pick(tile.index);
      }
      this.at = tile.place;
    },
    pick(index) {
      // shown at once; the server's answer has the last word
      const has = this.chosen.includes(index);
      this.chosen = has ? this.chosen.filter((one) => one !== index) : [...this.chosen, index];
      this.$emit("pick", { toggle: index });
    },
    key(event) {
      const step = { ArrowRight: 1, ArrowLeft: -1, ArrowDown: this.columns, ArrowUp: -this.columns }[event.key];
      if (step !== undefined) {
        this.at = Math.min(Math.max(0, this.at + step), this.indices.length - 1);
        this.bringIn(this.at);
        event.preventDefault();
      } else if ((event.key === " " || event.key === "Enter") && this.at >= 0) {
        this.pick(this.indices[this.at]);
        event.preventDefault();
      }
    },
  },
};
