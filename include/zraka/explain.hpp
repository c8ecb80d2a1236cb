// SPDX-License-Identifier: Apache-2.0
// Why a pixel has its colour: its ray tree with every term, as the renderer's own steps computed
// it.
//
// A Float3 is the engine's own numbers, to the bit: a colour, or a vector in world directions.
// Folded as docs/explain.md says, they give the picture's pixel bit for bit. Positions and
// distances are in the world's units.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>
#include <zraka/explained_shape.hpp>
#include <zraka/render.hpp>

namespace zraka {

/// What a light does at a hit.
enum class Reach {
  lit,        ///< the shadow ray reaches it
  unchecked,  ///< it lies before the surface, and the stage has no shadow rays
  behind,     ///< L·N < 0: neither diffuse nor specular
  blocked,    ///< the shadow ray hits a shape before the light; of a surface, all of them
  dark        ///< the hit is outside of the spot's cone
};

/// Of the shapes that a shadow ray hits, the one nearest to the hit.
struct Blocker {
  NamedShape shape;
  double distance = 0;  ///< from the shadow ray's start
  ExplainedPath path{};
};

/// A body that a shadow ray passes, or that stops it.
struct PassedBody {
  NamedShape shape;
  ExplainedPath path{};
  double distance = 0;           ///< from the shadow ray's start
  Float3 share{};                ///< k2; 1 where the body has taken its share before, 0 stops the light
  double length = 0;             ///< of the way before it, inside of what absorbs
  Float3 transmittance{1, 1, 1};  ///< what is left after that
};

/// The way from the last of them, or from the hit, to the light, inside of what absorbs.
struct LastStretch {
  double length = 0;
  Float3 transmittance{};
};

/// One light at one hit. Terms that are not there were not added. Of a light that is a surface the
/// way, R·V and the highlight are those of the first sample, the terms the means of all.
struct LightTerms {
  Reach reach = Reach::lit;
  double distance = 0;  ///< from the hit to the light
  Float3 to_light{};    ///< L, unit length
  float l_n = 0;        ///< L·N
  std::optional<Blocker> blocker{};
  std::optional<Float3> diffuse{};   ///< (Ii·kd)·(L·N)
  std::optional<float> r_v{};        ///< R·V; below 0 there is no specular term
  std::optional<float> highlight{};  ///< (R·V)^n
  std::optional<Float3> specular{};  ///< (Ii·ks)·(R·V)^n
  Float3 arriving{};                 ///< Ii, less what distance and the spot's cone take
  /// What transparent bodies leave of that, and which they are, in the order of distance.
  std::optional<Float3> filter{};
  std::vector<PassedBody> passed{};
  std::optional<LastStretch> last{};
  int samples = 1, facing = 1, reaching = 1;  ///< shadow rays: all, those that face it, that reach it
};

/// Snell's law at a hit whose material refracts (sheet 3.5).
struct SnellTerms {
  float cosine = 0;          ///< cos α = U·N
  float ratio = 0;           ///< b = n1/n2
  float quarter_d = 0;       ///< D/4 = b²·cos²α - b² + 1
  bool total = false;        ///< D < 0: total internal reflection
  std::optional<float> a{};  ///< √(D/4) - b·cos α, if the refracted ray exists
  double n1 = 0, n2 = 0;     ///< what b is the quotient of; 0: only b is known
  std::optional<double> fresnel{};  ///< the share that the angle moves to reflection
  std::optional<double> nm{};       ///< of which wavelength these are, where that matters
};

/// Why a hit has no reflected or no refracted ray.
enum class Absence {
  none,   ///< it has one
  share,  ///< its share is 0
  depth,  ///< the deepest level is reached
  stage,  ///< the stage does not have such rays
  total,  ///< total internal reflection
  contribution  ///< it could bring the pixel less than is asked for (sheet 8.3)
};

/// A missing ray of this weight in the pixel is worth a word.
inline constexpr double kNotableWeight = 0.1;

struct Child {
  float share = 0;  ///< k1 or k2 as the fold takes it, of channels the most; 0 if there is no ray
  Float3 shares{};  ///< the same of each channel
  int ray = -1;     ///< index in RayTree::rays; -1: none
  Absence absence = Absence::none;
  /// What a ray that the depth cuts off would bring, followed two levels further; only where its
  /// weight is notable.
  std::optional<Float3> beyond{};
  /// Of a ray that is not traced for its contribution: what it could have brought the pixel at
  /// most; of wavelengths that are not, all of them together.
  std::optional<double> bound{};
};

/// A refracted ray of one part of the spectrum.
struct SplitChild {
  double nm = 0;  ///< the middle of its part
  Child child;
};

/// What a ray has come through to its hit.
struct ThroughMedium {
  std::uint32_t material = 0;  ///< index in Scene::materials
  std::string name;
  Float3 absorption{};         ///< per unit of length
  Float3 transmittance{};      ///< exp(-a·d)
};

/// What fog does to a ray's colour C: C·left + color·(1 - left).
struct ThroughFog {
  float left = 1;
  Float3 color{};  ///< the fog's
};

/// What the profile takes from the sky in place of rays that are too deep to be traced.
struct SkyBeyond {
  Float3 reflected{}, refracted{};  ///< share times the sky's colour
};

/// A body that a ray is inside of.
struct NamedBody {
  NamedShape shape;
  ExplainedPath path{};
};

/// A hit on the cap that a cut has made of what it has opened.
struct ExplainedCap {
  std::uint32_t cut = 0;  ///< index in Scene::cuts
  bool eye_only = false;  ///< only rays from the eye see it
};

struct ExplainedHit {
  NamedShape shape;      ///< of the scene; an instance where it stands in a group
  ExplainedPath path{};  ///< from there on
  std::optional<ExplainedCrossings> crossings{};  ///< of a CSG shape
  std::optional<ExplainedCap> cap{};              ///< none: it is the shape's own surface
  double distance = 0;                            ///< from the ray's origin
  Vec3 point;
  /// From the shape's own space to the world, where that has one; with all its instances'.
  std::optional<Transform> transform{};
  std::optional<OwnPlace> own{};  ///< where there is a transform, or a texture was looked up
  std::vector<TexturedCoefficient> textures{};
  std::optional<TexturedNormal> bent{};
  Float3 normal{};       ///< N, towards the side that the ray came from
  bool flipped = false;  ///< N was turned: the ray came from inside, or from a flat shape's back
  Float3 ka{}, kd{}, ks{};
  float shininess = 0, k1 = 0, k2 = 0;  ///< k1 and k2: of channels the most
  Float3 reflection{}, refraction{};    ///< k1 and k2 of each channel, before Fresnel
  Highlight highlight = Highlight::phong;
  std::optional<Float3> occlusion{};      ///< how much of the ambient light arrives
  std::optional<ThroughMedium> medium{};  ///< that absorbs
  Float3 ambient{};  ///< Ia·ka; 1 for a silhouette, 0 where the stage has none
  std::vector<LightTerms>
      lights;      ///< in the scene's order; empty where the stage has no such terms
  Float3 local{};  ///< ambient and all lights' terms
  std::optional<SnellTerms> snell;
  Child reflected, refracted;
  std::optional<SkyBeyond> sky_beyond{};  ///< added after `local`
  /// In the place of `refracted`, where a body is dispersive; then that says whether wavelengths
  /// were left out for their contribution.
  std::vector<SplitChild> split{};
  Float3 sum{};  ///< local + k1·Crefl + k2·Crefr, before it is clamped, then times `medium`'s
};

enum class RayKind { camera, reflected, refracted };

struct ExplainedRay {
  RayKind kind = RayKind::camera;
  int depth = 0;
  int parent = -1;    ///< index in RayTree::rays
  double weight = 1;  ///< product of the shares on the way to the pixel, of channels the most
  Float3 shares{1, 1, 1};           ///< of its colour in its parent's sum
  std::optional<double> nm{};       ///< its wavelength, if it is one part of a split ray
  std::vector<NamedBody> inside{};  ///< where bodies absorb or have priorities
  Vec3 origin{};
  Float3 direction{};                 ///< unit length
  std::optional<ExplainedHit> hit{};  ///< none: the ray brings the sky's colour
  std::optional<ThroughFog> fog{};    ///< that it has come through
  Float3 color{};                     ///< what it brings back
};

/// The camera ray first, then level by level.
struct RayTree {
  std::vector<ExplainedRay> rays;
};

struct ExplainedLight {
  Vec3 position;
  Float3 color{};  ///< Ii
  Light light{};   ///< as the scene describes it
};

/// Rules of the sheet that a lesson breaks (the school library), in both languages.
struct VariedRules {
  std::string key;                ///< for JSON
  std::string english, croatian;  ///< what is done, as a sentence without a full stop
  /// Total internal reflection adds white in the share of the ray that cannot be refracted.
  bool white_when_total = false;
};

struct Explanation {
  std::uint32_t x = 0, y = 0;
  Resolution resolution;
  Terms terms;
  Profile profile;
  int max_depth = 0;
  /// What makes the pixel another one than render()'s, where a lesson varies the rules.
  std::optional<VariedRules> varied{};
  Float3 ambient_light{};  ///< Ia
  Float3 background{};
  Sky::Kind sky = Sky::Kind::flat;  ///< what rays see that hit nothing; flat: the background
  std::vector<ExplainedLight> lights{};
  /// Whether there is more than the lab's optics; then what rays of less than this contribution
  /// were cut off, of which none brings more than `brightest`; into how many dispersion splits.
  bool general = false;
  double min_contribution = 0, brightest = 0;
  int wavelengths = 0;
  bool transparent_shadows = false;
  std::uint32_t sample = 0, samples = 1;  ///< which of the pixel's is explained
  /// One; or four where the pixel is the mean of its corners: upper left, upper right, lower left,
  /// lower right.
  std::vector<RayTree> trees{};
  Float3 color{};  ///< the picture's, to the bit, before outlines
  bool outlined = false;  ///< an outline of RenderOptions::outlines goes over it: it is black
};

/// Pixels around one, as the picture has them.
struct Neighbourhood {
  std::uint32_t left = 0, top = 0;  ///< position in the picture of its upper left pixel
  Image image;
};

struct Variation;

/// Explains pixels of one scene. The scene must outlive it.
class ZRAKA_API Explainer {
 public:
  /// Fails as render() does; and for Isa::oracle, whose numbers are none of a picture's.
  static Result<Explainer> create(const Scene& scene, const RenderOptions& options = {});
  static Result<Explainer> create(Scene&& scene, const RenderOptions& options = {}) = delete;
  Explainer(Explainer&&) noexcept;
  Explainer& operator=(Explainer&&) noexcept;
  ~Explainer();

  /// Column x, row y from the picture's upper left corner; of several samples, this one, counted
  /// from 0. Fails outside of the picture, of the samples, and where a tree has more rays or terms
  /// than kMaxExplainedRays and kMaxExplainedTerms.
  Result<Explanation> pixel(std::uint32_t x, std::uint32_t y, std::uint32_t sample = 0);

  /// A square of at most side×side pixels, 1 ≤ side < kMaxTile, around a pixel of the picture, in
  /// its middle where the picture's edges leave room.
  Neighbourhood around(std::uint32_t x, std::uint32_t y, std::uint32_t side);

 private:
  friend Result<Explainer> varied_explainer(const Scene& scene, const RenderOptions& options,
                                            const Variation& variation);
  struct Impl;
  explicit Explainer(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

/// Explains one pixel.
ZRAKA_API Result<Explanation> explain(const Scene& scene, const RenderOptions& options,
                                      std::uint32_t x, std::uint32_t y);

}  // namespace zraka
