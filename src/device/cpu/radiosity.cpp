// SPDX-License-Identifier: Apache-2.0
#include "device/cpu/radiosity.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "kernel/cameras/projections.h"

namespace sundog::cpu {
namespace {

constexpr int kFewestRays = 8;
/// Of the last pass over the picture, at least.
constexpr float kFineColumns = 320;
/// Growth of the error bound with each bounce, and how far it may go.
constexpr float kWiderByBounce = 1.5F, kWidestBound = 1.8F;
/// Points that are taken at once: as many as half of what is known, so that few are taken in vain, in these limits.
constexpr std::size_t kFewestAtOnce = 32, kMostAtOnce = 1024;
/// And as many as have so many rays, each of which may find a gap: memory for those.
constexpr std::size_t kMostRaysAtOnce = 2'000'000;
/// Of the picture that one pass looks at.
constexpr float kMostPoints = 4e6F;
constexpr float kLeastReach = 1e-20F;

Vec3 from_kernel(const kernel::vec3& v) { return {v.x, v.y, v.z}; }

/// A fixed shuffling of numbers below `count`.
std::vector<std::uint32_t> shuffled(std::size_t count) {
    std::vector<std::uint32_t> order(count);
    std::iota(order.begin(), order.end(), 0U);
    const auto key = [](std::uint32_t i) {
        std::uint64_t h = (i + 1) * 0x9e3779b97f4a7c15ULL;
        h = (h ^ (h >> 30U)) * 0xbf58476d1ce4e5b9ULL;
        return h ^ (h >> 27U);
    };
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
    return order;
}

}  // namespace

/// Answers with what is known at one bounce. Looks for gaps: notes the points where too little is known.
class Radiosity::Light final : public kernel::IndirectLight {
public:
    Light(const Radiosity& owner, int bounce, Task task, std::vector<GatherPoint>* gaps)
        : owner_(owner), bounce_(bounce), task_(task), gaps_(gaps) {}

    void answer(const kernel::SceneView&, kernel::IndirectQuery& q) const override {
        const bool none = bounce_ >= owner_.settings_.recursion_limit;
        for (std::size_t lane = 0; lane < static_cast<std::size_t>(q.lanes); ++lane) {
            Vec3 light;
            if (q.wanted[lane] != 0 && !none) {
                const GatherPoint point{{q.x[lane], q.y[lane], q.z[lane]},
                                        {q.normal_x[lane], q.normal_y[lane], q.normal_z[lane]},
                                        {q.face_x[lane], q.face_y[lane], q.face_z[lane]},
                                        q.error[lane]};
                light = light_at(point);
            }
            q.red[lane] = light.x, q.green[lane] = light.y, q.blue[lane] = light.z;
        }
    }

    [[nodiscard]] bool uses_bent_normals() const override { return owner_.settings_.bent_normals; }

private:
    [[nodiscard]] Vec3 light_at(const GatherPoint& point) const {
        const IrradianceCache& cache = owner_.caches_[static_cast<std::size_t>(bounce_)];
        const IrradianceCaching& settings = owner_.settings_;
        if (gaps_ != nullptr) {
            if (!owner_.is_covered(point, bounce_, task_)) gaps_->push_back(point);
            return {};
        }
        IrradianceLookup found;
        if (task_ == Task::shade)
            found = cache.lookup(point.position, point.normal, owner_.error_bound(bounce_) * settings.low_error_factor);
        if (found.count == 0) found = cache.lookup(point.position, point.normal, owner_.error_bound(bounce_));
        if (found.count > 0) return found.light;
        // Nothing near by: a sample for this point alone, so that no other's light changes.
        BatchRays rays;
        return owner_.gather(point, bounce_, Task::draw, nullptr, rays).light;
    }

    const Radiosity& owner_;
    int bounce_;
    Task task_;
    std::vector<GatherPoint>* gaps_;
};

Radiosity::Radiosity(const Frame& frame, const kernel::SceneView& scene, RayKernel trace)
    : frame_(frame), settings_(*frame.radiosity), scene_(scene), matt_lights_(frame.lights), trace_(trace) {
    scene_.frame.working_gamma = 1;
    scene_.frame.min_weight = settings_.min_weight;
    scene_.frame.aovs = kernel::AOV_DEPTH;
    if (!settings_.through_media) {
        scene_.frame.fog_count = 0;
        scene_.frame.rainbows = kernel::NONE;
        scene_.frame.features &= ~(kernel::FEATURE_MEDIA | kernel::FEATURE_HOLLOW);
    }
    // Povray's default: what surfaces send each other doesn't go below them.
    scene_.frame.features &= ~kernel::FEATURE_SUBSURFACE;
    // What the eye is inside of isn't where light is gathered.
    std::fill(std::begin(scene_.frame.eye_insides), std::end(scene_.frame.eye_insides), kernel::NONE);
    scene_.frame.eye_interiors_inner = scene_.frame.eye_interiors_outer = 0;
    for (kernel::Light& light : matt_lights_) {
        light.flags &= ~kernel::LIGHT_HIGHLIGHTS;
        light.area_count_u = light.area_count_v = 1;
    }
    scene_.lights = matt_lights_.data();
    for (int bounce = 0; bounce < settings_.recursion_limit; ++bounce) {
        caches_.emplace_back(error_bound(bounce));
        const int count = bounce < 8 ? settings_.count >> static_cast<unsigned>(bounce) : 0;
        hemispheres_.emplace_back(std::max(count, std::min(settings_.count, kFewestRays)));
    }
    light_ = std::make_unique<Light>(*this, 0, Task::draw, nullptr);
}

const kernel::IndirectLight& Radiosity::light() const { return *light_; }

float Radiosity::error_bound(int bounce) const {
    // What comes from further bounces is averaged over many rays; a generous bound needn't be any wider.
    const float widened = settings_.error_bound * std::pow(kWiderByBounce, static_cast<float>(bounce));
    return std::max(settings_.error_bound, std::min(widened, kWidestBound));
}

bool Radiosity::is_covered(const GatherPoint& point, int bounce, Task task) const {
    // One sample is enough for further bounces, and for what passes over the picture have left out.
    // Where some is loaded, passes have been over the picture already.
    const bool needs_all = !settings_.loaded && (task == Task::draw ? settings_.always_sample : bounce == 0);
    return caches_[static_cast<std::size_t>(bounce)].has(needs_all ? settings_.nearest_count : 1, point.position,
                                                         point.normal,
                                                         error_bound(bounce) * settings_.low_error_factor);
}

IrradianceSample Radiosity::gather(const GatherPoint& point, int bounce, Task task, std::vector<GatherPoint>* gaps,
                                   BatchRays& rays) const {
    const Light next(*this, bounce + 1, task, gaps);
    kernel::SceneView scene = scene_;
    scene.indirect = &next;
    scene.first_ray_kind = kernel::RAY_RADIOSITY;
    if (gaps != nullptr) scene.frame.light_count = 0;
    const Hemisphere& around = hemispheres_[static_cast<std::size_t>(bounce)];
    const Hemisphere::Frame axes(point.normal);
    const Vec3 origin = point.position + point.face * point.error;
    const auto count = around.directions().size();
    std::vector<BatchRay> batch(count);
    std::vector<BatchAnswer> answers(count);
    for (std::size_t i = 0; i < count; ++i) {
        Vec3 direction = normalize(axes.to_world(around.directions()[i]));
        // A smooth normal's hemisphere reaches under the face.
        const float into = dot(direction, point.face);
        if (into < 0) direction = direction - point.face * (2 * into);
        batch[i] = {origin, direction};
    }
    rays = trace_(scene, batch, answers);
    IrradianceSample sample{point.position, point.normal, {}};
    if (gaps != nullptr) return sample;
    for (BatchAnswer& answer : answers) {
        if (!is_finite(answer.radiance)) answer.radiance = {};
        const float most = std::max({answer.radiance.x, answer.radiance.y, answer.radiance.z});
        if (settings_.max_sample > 0 && most > settings_.max_sample) answer.radiance *= settings_.max_sample / most;
        answer.radiance = adjusted(answer.radiance);
    }
    around.integrate(answers, axes, sample);
    const float from_eye = length(point.position - from_kernel(scene_.frame.camera.eye));
    sample.reach = std::clamp(sample.reach, settings_.minimum_reuse * from_eye, settings_.maximum_reuse * from_eye);
    sample.reach = std::max(sample.reach, kLeastReach);
    sample.limit_gradients();
    return sample;
}

Vec3 Radiosity::adjusted(Vec3 light) const {
    const float gray = kernel::gray_of({light.x, light.y, light.z});
    const float grayness = settings_.gray_threshold;
    return (light * (1 - grayness) + Vec3{gray, gray, gray} * grayness) * settings_.brightness;
}

template <class Function>
void Radiosity::for_each(std::size_t count, const Function& function) {
    std::vector<BatchRays> rays(count);
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) { function(i, rays[i]); });
    for (const BatchRays& r : rays) {
        rays_.rays += r.rays;
        rays_.shadow_rays += r.shadow_rays;
    }
}

BatchRay Radiosity::eye_ray(float x, float y) const {
    const kernel::FrameParams& params = frame_.params;
    if (!frame_.camera_rays) {
        const kernel::Ray ray =
            camera_ray(params, x / static_cast<float>(params.width), y / static_cast<float>(params.height));
        return {from_kernel(ray.origin), from_kernel(ray.direction), ray.t_max};
    }
    CameraRays::Place place;
    place.x = std::min(static_cast<std::uint32_t>(x), params.width - 1);
    place.y = std::min(static_cast<std::uint32_t>(y), params.height - 1);
    place.dx = x - static_cast<float>(place.x);
    place.dy = y - static_cast<float>(place.y);
    const std::optional<CameraRays::Ray> ray = frame_.camera_rays->ray(params, place);
    return ray ? BatchRay{ray->origin, ray->direction, ray->reach} : BatchRay{{}, {0, 0, 1}, -1};
}

std::vector<GatherPoint> Radiosity::gaps_of_picture(float step, float shift, Task task) {
    const auto width = static_cast<float>(scene_.frame.width);
    const auto height = static_cast<float>(scene_.frame.height);
    const auto rows = static_cast<std::size_t>(std::ceil(height / step));
    const auto columns = static_cast<std::size_t>(std::ceil(width / step));
    std::vector<std::vector<GatherPoint>> of_row(rows);
    for_each(rows, [&](std::size_t row, BatchRays& rays) {
        const Light light(*this, 0, task, &of_row[row]);
        kernel::SceneView scene = scene_;
        scene.indirect = &light;
        scene.frame.light_count = 0;
        scene.frame.min_weight = frame_.params.min_weight;
        std::vector<BatchRay> batch(columns);
        std::vector<BatchAnswer> answers(columns);
        for (std::size_t column = 0; column < columns; ++column) {
            batch[column] = eye_ray(std::min((static_cast<float>(column) + shift) * step, width),
                                    std::min((static_cast<float>(row) + shift) * step, height));
        }
        rays = trace_(scene, batch, answers);
    });
    std::vector<GatherPoint> gaps;
    for (const std::vector<GatherPoint>& row : of_row) gaps.insert(gaps.end(), row.begin(), row.end());
    return gaps;
}

void Radiosity::fill(std::vector<GatherPoint> wanted, int bounce, Task task, const StopFlag& stop) {
    IrradianceCache& cache = caches_[static_cast<std::size_t>(bounce)];
    const std::vector<std::uint32_t> order = shuffled(wanted.size());
    const std::size_t rays_each = hemispheres_[static_cast<std::size_t>(bounce)].directions().size();
    const std::size_t most = std::max(kMostRaysAtOnce / rays_each, std::size_t{1});
    for (std::size_t next = 0; next < order.size() && !stop.requested();) {
        const std::size_t size =
            std::min({std::clamp(cache.size() / 2, kFewestAtOnce, kMostAtOnce), most, order.size() - next});
        std::vector<GatherPoint> points;
        for (std::size_t i = 0; i < size; ++i) {
            const GatherPoint& point = wanted[order[next + i]];
            if (!is_covered(point, bounce, task)) points.push_back(point);
        }
        next += size;
        if (bounce + 1 < settings_.recursion_limit) {
            std::vector<std::vector<GatherPoint>> gaps(points.size());
            for_each(points.size(), [&](std::size_t i, BatchRays& rays) {
                (void)gather(points[i], bounce, Task::shade, &gaps[i], rays);
            });
            std::vector<GatherPoint> all;
            for (const std::vector<GatherPoint>& some : gaps) all.insert(all.end(), some.begin(), some.end());
            fill(std::move(all), bounce + 1, Task::shade, stop);
        }
        std::vector<IrradianceSample> samples(points.size());
        for_each(points.size(), [&](std::size_t i, BatchRays& rays) {
            samples[i] = gather(points[i], bounce, Task::shade, nullptr, rays);
        });
        for (const IrradianceSample& sample : samples) cache.add(sample);
    }
}

void Radiosity::take_loaded() {
    if (!settings_.loaded) return;
    for (const StoredIrradiance& stored : *settings_.loaded)
        if (stored.bounce < caches_.size()) caches_[stored.bounce].add(stored.sample);
}

void Radiosity::keep_all() const {
    if (!settings_.store) return;
    StoredRadiosity all;
    for (std::size_t bounce = 0; bounce < caches_.size(); ++bounce)
        for (const IrradianceSample& sample : caches_[bounce].samples())
            all.push_back({sample, static_cast<std::uint32_t>(bounce)});
    settings_.store->keep(all);
}

bool Radiosity::prepare(const StopFlag& stop) {
    take_loaded();
    const auto width = static_cast<float>(scene_.frame.width);
    const float finest = std::max(std::sqrt(width * static_cast<float>(scene_.frame.height) / kMostPoints), 1.0F);
    const float last = std::max(settings_.pretrace_end * width, finest);
    for (float step = std::max(settings_.pretrace_start * width, last); step >= last * 0.99F && !stop.requested();
         step *= 0.5F)
        fill(gaps_of_picture(step, 0.5F, Task::shade), 0, Task::shade, stop);
    // What passes that are coarser than the pixels have not seen.
    // Samples reach as far as a share of the picture's width, so a large picture's pixels needn't all be asked.
    const float fine = std::max(std::floor(width / kFineColumns), 1.0F);
    if (!stop.requested()) fill(gaps_of_picture(fine, 0.5F, Task::draw), 0, Task::draw, stop);
    if (stop.requested()) return false;
    keep_all();
    return true;
}

}  // namespace sundog::cpu
