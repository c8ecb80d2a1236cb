// SPDX-License-Identifier: Apache-2.0
// Listens to the general engine on one sample of one pixel.
#include "explain/general_reader.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "engine/general/steps.hpp"
#include "explain/hit_reader.hpp"
#include "render/sample_rays.hpp"
#include "render/tracer.hpp"

namespace zraka {
namespace {

float most_of(const Float3& v) {
  return std::max({v[0], v[1], v[2]});
}

class GeneralReader final : public general::Listener<float> {
 public:
  GeneralReader(const Stand& stand, const TraceSettings& settings, std::int32_t batch)
      : stand_(stand),
        settings_(settings),
        hit_reader_(stand.scene, *stand.prepared.store, stand.prepared.frame),
        memory_(batch, stand.frozen(), settings, true),
        first_(static_cast<std::size_t>(settings.max_depth) + 2) {
    memory_.general->workspace().listener = this;
  }

  /// Puts a sample's ray to where read() takes it from. False if there is none.
  bool place_sample(const CameraSample& sample);
  /// False if the tree does not fit.
  bool read();

  RayTree& tree() { return tree_; }
  const TooLarge& too_large() const { return too_large_; }

  void at_hits(const Level<float>& level, const Scratch<float>& s,
               const general::GeneralWorkspace<float>& workspace,
               const V3<float>* occlusion) override;
  void at_passed(const general::Passed<float>& passed) override;
  void at_light(std::int32_t light, const Level<float>& level,
                const general::LightSum<float>* sums) override;
  void at_children(const Level<float>& level, const Level<float>& next,
                   const general::GeneralWorkspace<float>& workspace) override;
  void at_fold(const Level<float>& level,
               const general::GeneralWorkspace<float>& workspace) override;

 private:
  struct Awaited {
    RayKind kind;
    int parent;
    double weight;
    Float3 shares{1, 1, 1};
    std::optional<double> nm{};
  };

  std::size_t depth_of(const Level<float>& level) {
    return static_cast<std::size_t>(&level - memory_.workspace().levels);
  }
  std::size_t ray_of_hit(const Level<float>& level, std::size_t h) {
    return first_[depth_of(level)] + static_cast<std::size_t>(level.hits.ray[h]);
  }
  ExplainedHit& hit(const Level<float>& level, std::size_t h) {
    return *tree_.rays[ray_of_hit(level, h)].hit;
  }
  ExplainedHit surface(const Level<float>& level, const Scratch<float>& s,
                       const general::HitState<float>& state, std::size_t h);
  void read_snell(ExplainedHit& at, const general::HitState<float>& state,
                  const general::RayState<float>& ray);
  void read_children(ExplainedHit& at, const general::HitState<float>& state,
                     const general::RayState<float>* children, std::size_t parent,
                     std::size_t first_of_next);
  Float3 fog_color() const;
  void read_cuts(ExplainedHit& at, const general::HitState<float>& state,
                 const general::RayState<float>& ray);

  const Stand& stand_;
  const TraceSettings& settings_;
  HitReader hit_reader_;
  TracerMemory<float> memory_;
  RayTree tree_;
  std::vector<std::size_t> first_;
  std::vector<Awaited> awaited_{{RayKind::camera, -1, 1.0}};
  /// What bodies that rays are inside of are called, as far as their surfaces have been hit.
  std::map<std::uint64_t, NamedBody> bodies_;
  /// Of the light at hand, by hit: what its first sample passes.
  std::map<std::int32_t, std::vector<PassedBody>> passed_;
  std::map<std::int32_t, LastStretch> last_;
  TooLarge too_large_;
};

bool GeneralReader::place_sample(const CameraSample& sample) {
  const SampleRays<float> samples(stand_.frozen().camera, stand_.options.profile,
                                  stand_.options.sampling, stand_.frozen().textures != nullptr);
  memory_.workspace().levels[0].ray_count = 1;
  return samples.make(sample.x, sample.y, sample.number, memory_.workspace(), 0) !=
         SampleRays<float>::Made::nothing;
}

bool GeneralReader::read() {
  RayCounts counts;
  trace_rays(*stand_.kernel, stand_.frozen(), settings_, memory_, counts);
  return !stop;
}

ExplainedHit GeneralReader::surface(const Level<float>& level, const Scratch<float>& s,
                                    const general::HitState<float>& state, std::size_t h) {
  const auto ray = static_cast<std::size_t>(level.hits.ray[h]);
  const float* m = s.coefficients + std::ptrdiff_t{s.row[h]} * kMaterialReals;
  const OpticalMaterial& material = stand_.frozen().optics->materials[s.material[h]];
  ExplainedHit hit;
  hit.shape = stand_.named(s.slot[ray]);
  hit.distance = stand_.length(s.t[ray]);
  hit.point = stand_.world_point(s.px[h], s.py[h], s.pz[h]);
  hit.normal = {s.nx[h], s.ny[h], s.nz[h]};
  hit.flipped = s.inside[h] > 0;
  hit.ka = {m[kAmbient], m[kAmbient + 1], m[kAmbient + 2]};
  hit.kd = {m[kDiffuse], m[kDiffuse + 1], m[kDiffuse + 2]};
  hit.ks = {m[kSpecular], m[kSpecular + 1], m[kSpecular + 2]};
  hit.shininess = m[kShininess];
  hit.reflection = float3(general::reflection_of(material, m));
  hit.refraction = float3(general::refraction_of(material, m));
  hit.k1 = most_of(hit.reflection);
  hit.k2 = most_of(hit.refraction);
  hit.highlight = material.highlight;
  hit.ambient = {level.hits.r[h], level.hits.g[h], level.hits.b[h]};
  const auto absence = [&](float share, bool in_stage) {
    if (share == 0) return Absence::share;
    return in_stage && !settings_.terms.silhouette ? Absence::depth : Absence::stage;
  };
  // By Fresnel, what refracts reflects as well.
  hit.reflected.absence = absence(hit.k1 == 0 && material.fresnel != Fresnel::off ? hit.k2 : hit.k1,
                                  settings_.terms.reflection);
  hit.refracted.absence = absence(hit.k2, settings_.terms.refraction);
  hit_reader_.read(level, s, h, ray, hit);
  if (state.cap >= 0) {
    hit.cap = {static_cast<std::uint32_t>(state.cap),
               stand_.frozen().optics->cuts[state.cap].eye_only};
    // Those are of the surface behind it.
    hit.path.member.reset();
    hit.crossings.reset();
  }
  if (state.medium >= 0 && stand_.frozen().optics->materials[state.medium].absorbs()) {
    const auto index = static_cast<std::uint32_t>(state.medium);
    const Color& a = stand_.scene.materials[index].absorption;
    const auto name = stand_.scene.material_names.find(index);
    hit.medium = {index,
                  name == stand_.scene.material_names.end() ? std::string() : name->second,
                  {static_cast<float>(a.r), static_cast<float>(a.g), static_cast<float>(a.b)},
                  float3(state.transmittance)};
  }
  bodies_.insert({state.body, {hit.shape, hit.path}});
  return hit;
}

void GeneralReader::at_hits(const Level<float>& level, const Scratch<float>& s,
                            const general::GeneralWorkspace<float>& workspace,
                            const V3<float>* occlusion) {
  const std::size_t depth = depth_of(level);
  const std::size_t first = first_[depth] = tree_.rays.size();
  const general::HitState<float>* const states = workspace.hits[depth].data();
  for (std::size_t h = 0; h < static_cast<std::size_t>(level.hit_count); ++h)
    bodies_.insert(
        {states[h].body, {stand_.named(s.slot[level.hits.ray[h]]), hit_reader_.path(&s.paths[h])}});
  for (std::size_t i = 0; i < awaited_.size(); ++i) {
    const RayArrays<float>& rays = level.rays;
    ExplainedRay ray{.kind = awaited_[i].kind,
                     .depth = static_cast<int>(depth),
                     .parent = awaited_[i].parent,
                     .weight = awaited_[i].weight,
                     .shares = awaited_[i].shares,
                     .nm = awaited_[i].nm,
                     .origin = stand_.world_point(rays.ox[i], rays.oy[i], rays.oz[i]),
                     .direction = {rays.dx[i], rays.dy[i], rays.dz[i]}};
    const general::Inside inside =
        workspace.insides.empty() ? general::Inside() : workspace.insides[depth][i];
    for (std::int32_t b = 0; b < inside.count; ++b)
      if (const auto body = bodies_.find(inside.list[b].body); body != bodies_.end())
        ray.inside.push_back(body->second);
    tree_.rays.push_back(std::move(ray));
  }
  awaited_.clear();
  for (std::size_t h = 0; h < static_cast<std::size_t>(level.hit_count); ++h) {
    ExplainedHit found = surface(level, s, states[h], h);
    if (occlusion != nullptr) found.occlusion = float3(occlusion[h]);
    tree_.rays[first + static_cast<std::size_t>(level.hits.ray[h])].hit = std::move(found);
  }
  passed_.clear();
  last_.clear();
  const std::uint64_t terms =
      std::uint64_t{tree_.rays.size()} * static_cast<std::uint64_t>(stand_.frozen().light_count);
  if (terms <= kMaxExplainedTerms) return;
  too_large_ = {depth, first, tree_.rays.size() - first, terms};
  stop = true;
}

void GeneralReader::at_passed(const general::Passed<float>& passed) {
  if (passed.sample != 0 || stop) return;
  if (passed.slot < 0) {
    last_[passed.hit] = {stand_.prepared.frame.world_length(passed.length),
                         float3(passed.transmittance)};
    return;
  }
  passed_[passed.hit].push_back(
      {stand_.named(passed.slot), hit_reader_.path(passed.path),
       stand_.prepared.frame.world_length(passed.distance), float3(passed.share),
       stand_.prepared.frame.world_length(passed.length), float3(passed.transmittance)});
}

void GeneralReader::at_light(std::int32_t /*light*/, const Level<float>& level,
                             const general::LightSum<float>* sums) {
  if (stop) return;
  const Terms& stage = settings_.terms;
  for (std::size_t h = 0; h < static_cast<std::size_t>(level.hit_count); ++h) {
    const general::LightSum<float>& sum = sums[h];
    const int samples = sum.samples;
    LightTerms at{
        .reach = Reach::behind,
        .distance = stand_.prepared.frame.world_length(sum.distance),
        .to_light = {static_cast<float>(sum.to_light.x), static_cast<float>(sum.to_light.y),
                     static_cast<float>(sum.to_light.z)},
        .l_n = static_cast<float>(sum.l_n),
        .arriving = float3(sum.radiance),
        .samples = samples,
        .facing = sum.facing,
        .reaching = sum.lit};
    if (const auto passed = passed_.find(static_cast<std::int32_t>(h)); passed != passed_.end())
      at.passed = std::move(passed->second);
    if (const auto last = last_.find(static_cast<std::int32_t>(h)); last != last_.end()) {
      at.last = last->second;
      at.filter = float3(sum.filter);
    }
    if (sum.facing > 0) at.reach = sum.lit > 0 || !stage.shadows ? Reach::lit : Reach::blocked;
    if (sum.facing > 0 && !stage.shadows) at.reach = Reach::unchecked;
    const bool darkened = sum.radiance.x == 0 && sum.radiance.y == 0 && sum.radiance.z == 0;
    if (at.reach == Reach::blocked && darkened && samples == 1) at.reach = Reach::dark;
    if (!at.passed.empty()) {
      const PassedBody& last = at.passed.back();
      if (at.reach == Reach::blocked) at.blocker = {last.shape, last.distance, last.path};
      if (settings_.transparent_shadows) at.filter = float3(sum.filter);
    }
    const bool shines = stage.specular && hit(level, h).ks != Float3{};
    if (sum.lit > 0 && stage.diffuse) at.diffuse = float3(sum.diffuse);
    if (sum.lit > 0 && shines) {
      const bool first = float3(sum.filter) != Float3{} && !darkened;
      if (first) at.r_v = static_cast<float>(sum.cosine);
      if (first && sum.cosine >= 0) at.highlight = static_cast<float>(sum.highlight);
      if (at.highlight || float3(sum.specular) != Float3{}) at.specular = float3(sum.specular);
    }
    hit(level, h).lights.push_back(std::move(at));
  }
  passed_.clear();
  last_.clear();
}

void GeneralReader::read_snell(ExplainedHit& at, const general::HitState<float>& state,
                               const general::RayState<float>& ray) {
  at.snell = {.cosine = static_cast<float>(state.cosine),
              .ratio = static_cast<float>(state.ratio),
              .quarter_d = static_cast<float>(state.quarter_d),
              .total = state.total,
              .n1 = state.n1,
              .n2 = state.n2};
  const OpticalMaterial& material = stand_.frozen().optics->materials[state.material];
  if (material.fresnel != Fresnel::off) at.snell->fresnel = state.total ? 1 : state.fresnel;
  const Wavelengths& waves = settings_.wavelengths;
  if (state.split)
    at.snell->nm = waves.um[waves.count / 2] * 1000;
  else if (ray.wavelength >= 0)
    at.snell->nm = waves.um[ray.wavelength] * 1000;
  if (!state.total)
    at.snell->a = static_cast<float>(std::sqrt(state.quarter_d) - state.ratio * state.cosine);
}

/// Why hits that have been asked for their children do not have them.
void GeneralReader::read_cuts(ExplainedHit& at, const general::HitState<float>& state,
                              const general::RayState<float>& ray) {
  if (state.refracts && state.total && !state.split) at.refracted.absence = Absence::total;
  const auto settle = [&](Child& child, bool cut, const std::array<double, 3>& missing) {
    if (child.ray < 0 && child.absence == Absence::depth) child.absence = Absence::share;
    if (!cut) return;
    child.absence = Absence::contribution;
    const Float3 weight = float3(ray.weight * state.transmittance);
    child.bound = 0;
    for (std::size_t c = 0; c < 3; ++c)
      child.bound = std::max(*child.bound, std::fabs(static_cast<double>(weight[c])) * missing[c]);
  };
  const Float3 all = float3(state.missing), shares = float3(state.reflection);
  std::array<double, 3> of_reflected{}, of_refracted{};
  for (std::size_t c = 0; c < 3; ++c) {
    if (state.reflected_cut)
      of_reflected[c] = std::fabs(static_cast<double>(shares[c])) * settings_.brightest;
    of_refracted[c] = std::max(static_cast<double>(all[c]) - of_reflected[c], 0.0);
  }
  settle(at.reflected, state.reflected_cut, of_reflected);
  settle(at.refracted, state.refracted_cut, of_refracted);
  if (!at.split.empty() && !state.refracted_cut) at.refracted.absence = Absence::none;
}

void GeneralReader::read_children(ExplainedHit& at, const general::HitState<float>& state,
                                  const general::RayState<float>* children, std::size_t parent,
                                  std::size_t first_of_next) {
  for (std::int32_t c = state.first_child; c < state.first_child + state.child_count; ++c) {
    const general::RayState<float>& ray = children[c];
    const Float3 shares = float3(ray.share);
    const Child child{most_of(shares), shares,
                      static_cast<int>(first_of_next) + static_cast<int>(c)};
    Awaited& awaited = awaited_[static_cast<std::size_t>(c)];
    awaited = {ray.kind == general::RayKind::reflected ? RayKind::reflected : RayKind::refracted,
               static_cast<int>(parent), static_cast<double>(most_of(float3(ray.weight))), shares};
    if (ray.wavelength >= 0) awaited.nm = settings_.wavelengths.um[ray.wavelength] * 1000;
    if (ray.kind == general::RayKind::reflected)
      at.reflected = child;
    else if (state.split)
      at.split.push_back({*awaited.nm, child});
    else
      at.refracted = child;
  }
}

void GeneralReader::at_children(const Level<float>& level, const Level<float>& next,
                                const general::GeneralWorkspace<float>& workspace) {
  const auto more = static_cast<std::size_t>(next.ray_count);
  const std::size_t first_of_next = tree_.rays.size(), depth = depth_of(level);
  if (first_of_next + more > kMaxExplainedRays || next.ray_count > memory_.workspace().batch) {
    if (!stop) too_large_ = {depth + 1, first_of_next, more, 0};
    stop = true;
  }
  if (stop) return;
  awaited_.resize(more);
  for (std::size_t h = 0; h < static_cast<std::size_t>(level.hit_count); ++h) {
    ExplainedHit& at = hit(level, h);
    const general::HitState<float>& state = workspace.hits[depth][h];
    const general::RayState<float>& ray =
        workspace.rays[depth][static_cast<std::size_t>(level.hits.ray[h])];
    if (state.refracts) read_snell(at, state, ray);
    read_children(at, state, workspace.rays[depth + 1].data(), ray_of_hit(level, h), first_of_next);
    read_cuts(at, state, ray);
  }
}

void GeneralReader::at_fold(const Level<float>& level,
                            const general::GeneralWorkspace<float>& workspace) {
  if (stop) return;
  const std::size_t depth = depth_of(level), first = first_[depth];
  for (std::size_t i = 0; i < static_cast<std::size_t>(level.ray_count); ++i)
    tree_.rays[first + i].color = {level.rays.r[i], level.rays.g[i], level.rays.b[i]};
  for (std::size_t h = 0; h < static_cast<std::size_t>(level.hit_count); ++h) {
    const general::HitState<float>& state = workspace.hits[depth][h];
    ExplainedHit& at = hit(level, h);
    at.local = {level.hits.r[h], level.hits.g[h], level.hits.b[h]};
    at.sum = float3(state.sum);
    const SkyBeyond beyond{float3(state.beyond_reflected), float3(state.beyond_refracted)};
    if (beyond.reflected != Float3{} || beyond.refracted != Float3{}) at.sky_beyond = beyond;
    if (state.clear != 1) tree_.rays[ray_of_hit(level, h)].fog = {state.clear, fog_color()};
  }
  const OpticalFog& fog = stand_.frozen().optics->fog;
  if (fog.kind == Fog::Kind::none || fog.planar) return;
  const auto left =
      static_cast<float>(general::clear_share(fog, std::numeric_limits<double>::infinity()));
  for (std::size_t i = 0; i < static_cast<std::size_t>(level.ray_count); ++i)
    if (!tree_.rays[first + i].hit) tree_.rays[first + i].fog = {left, fog_color()};
}

Float3 GeneralReader::fog_color() const {
  return float3(general::narrowed<float>(stand_.frozen().optics->fog.color));
}

}  // namespace

std::optional<RayTree> read_general_tree(const Stand& stand, const TraceSettings& settings,
                                         const CameraSample& sample, std::int32_t batch,
                                         TooLarge& too_large) {
  GeneralReader reader(stand, settings, batch);
  if (!reader.place_sample(sample)) return RayTree();
  if (reader.read()) return std::move(reader.tree());
  too_large = reader.too_large();
  return std::nullopt;
}

}  // namespace zraka
