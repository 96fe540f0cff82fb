// The player of one scenario, and beside it what the ego's driver sees.
import { DriversSeat } from "scegen-seat";

export default {
  template: `<div class="cinema"><div class="cinema-player" ref="player"></div></div>`,
  props: { source: String, script: String },
  mounted() {
    this.show();
  },
  unmounted() {
    this.close();
  },
  watch: {
    source() {
      this.show();
    },
  },
  methods: {
    async show() {
      const source = this.source;
      this.close();
      if (!source) return;
      const [{ mount }, answer] = await Promise.all([import(this.script), fetch(source)]);
      if (!answer.ok || source !== this.source || !this.$refs.player) return;
      const { scene, before, environment } = await answer.json();
      this.player = mount(this.$refs.player, scene, { before });
      this.seat = new DriversSeat(this.player, scene, environment);
      this.$emit("shown", scene.name);
    },
    close() {
      this.seat?.destroy();
      this.player?.destroy();
      this.player = this.seat = null;
    },
    claim(id) {
      this.player?.claim(id);
    },
    // for tests and other pages
    current() {
      return this.player;
    },
  },
};
