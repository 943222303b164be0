using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>
/// Finds room for a new thing: where it cuts into nothing, as near as can be; on what was pointed at where that holds it, else on something level that is
/// seen around, else on anything.
/// </summary>
/// <param name="place">The place that was pointed at.</param>
/// <param name="late">What is in the text, and not in the picture yet; null for nothing.</param>
internal sealed class RoomBeside(PlaceInView place, Scene? late)
{
    // Rings of pixels around the one that was pointed at: as far apart as a quarter of a new thing, which is an eighth of the picture.
    private const int Rings = 16;
    private const int Directions = 12;
    private const float Step = 1f / 32;

    // In sizes: what stands farther away is not where somebody wanted it; but rather on the ground there than high on something.
    private const float Reach = 5;
    private const float GroundReach = 10;

    // As far around as a new thing reaches, a surface that holds it is flat: not the side of a ball. So alike are normals then, in half of the four places.
    private const float Extent = 1f / 8;
    private const float Flat = 0.98f;

    // The least cosine between the normals of places that are taken for one ground, and between that of what is level and the upward direction.
    private const float Alike = 0.95f;

    private static readonly Vector2[] _directions = Around();
    private readonly RayProbe[] _others = late is null ? [new(place.Shown.Scene)] : [new(place.Shown.Scene), new(late)];

    /// <summary>By what the body is moved from the place: not at all where it cuts into nothing, or where there is no room.</summary>
    /// <param name="body">The body.</param>
    /// <param name="put">What moves it to the place.</param>
    public Vector3 For(NewBody body, Vector3 put)
    {
        if (place.Ground is not { } up)
        {
            return default;
        }

        SeenPlace here = new(place.Pixel, Picking.At(place.Shown, place.Pixel.X, place.Pixel.Y));
        Vector3 upright = CameraController.Local(place.Shown).Inverse().Vector(place.Shown.Camera.Up).Unit();
        bool isHeld = up.Dot(upright) > Alike || IsFlat(here);
        bool isFree = IsFree(body, put);
        if (isHeld && isFree)
        {
            return default;
        }

        // Looked at as far as they are asked for.
        SeenPlace[]?[] rings = new SeenPlace[Rings][];
        IEnumerable<SeenPlace> seen = Enumerable.Range(0, Rings).SelectMany(i => rings[i] ??= Ring(i + 1));
        IEnumerable<SeenPlace> near = seen.Where(s => Distance(s) < Reach * place.View.Size);

        // The ground rather than what stands on it, whose tops are level, too.
        float Height(SeenPlace s) => MathF.Floor(s.Position.Dot(upright) / (place.View.Size / 4));
        return On(near.Where(s => isHeld && s.Pointer == here.Pointer && s.Normal.Dot(up) > Alike), body, put)
            ?? On(seen.Where(s => s.Normal.Dot(upright) > Alike).OrderBy(Height).Where(IsFlat), body, put)
            ?? (isFree ? default(Vector3) : On(near, body, put))
            ?? default;
    }

    private Vector3? On(IEnumerable<SeenPlace> places, NewBody body, Vector3 put)
    {
        Vector3 up = place.Ground!.Value;
        float below = place.Below(body, up);
        foreach (SeenPlace seen in places)
        {
            Vector3 normal = seen.Normal;
            bool isLevel = normal.Dot(up) > 1 - 1e-5f;
            Vector3 by = seen.Position - place.Point + (isLevel ? default : (normal * place.Below(body, normal)) - (up * below));

            // Round numbers, where the thing does not leave its ground by them.
            Vector3 round = place.View.Snap(by);
            by = isLevel && MathF.Abs((round - by).Dot(up)) < 1e-4f * place.View.Size ? round : by;
            if (IsFree(body, put + by))
            {
                return by;
            }
        }

        return null;
    }

    private bool IsFree(NewBody body, Vector3 by) => !Array.Exists(_others, o => body.Cuts(o, by));

    private bool IsFlat(SeenPlace at)
    {
        float away = Extent * place.Shown.Scene.Render.Height;
        Vector2[] around = [new(away, 0), new(-away, 0), new(0, away), new(0, -away)];
        return 2 * around.Count(by => Look(at.Pixel + by) is { } other && other.Pointer == at.Pointer && other.Normal.Dot(at.Normal) > Flat) >= around.Length;
    }

    private float Distance(SeenPlace seen) => (seen.Position - place.Point).Norm();

    // What is seen around the pixel, the nearest first. Every other ring is turned by half a step, so that it looks between the places of the last.
    private SeenPlace[] Ring(int ring)
    {
        float radius = ring * Step * place.Shown.Scene.Render.Height;
        IEnumerable<Vector2> directions = ring % 2 == 0 ? _directions : _directions.Select((d, i) => Vector2.Normalize(d + _directions[(i + 1) % Directions]));
        return [.. directions.Select(d => Look(place.Pixel + (radius * d))).OfType<SeenPlace>().Where(s => Distance(s) < GroundReach * place.View.Size).OrderBy(Distance)];
    }

    // Null where there is nothing, or no picture.
    private SeenPlace? Look(Vector2 pixel)
    {
        RenderDescription render = place.Shown.Scene.Render;
        bool isInside = pixel.X >= 0 && pixel.Y >= 0 && pixel.X < render.Width && pixel.Y < render.Height;
        return isInside && Picking.At(place.Shown, pixel.X, pixel.Y) is { Position: not null } seen ? new(pixel, seen) : null;
    }

    // Each is the one before, turned by a twelfth.
    private static Vector2[] Around()
    {
        const float sine = 0.5f;
        const float cosine = 0.8660254f;
        Vector2[] all = new Vector2[Directions];
        all[0] = Vector2.UnitX;
        for (int i = 1; i < Directions; i++)
        {
            all[i] = new((cosine * all[i - 1].X) - (sine * all[i - 1].Y), (sine * all[i - 1].X) + (cosine * all[i - 1].Y));
        }

        return all;
    }

    private sealed record SeenPlace(Vector2 Pixel, PickResult Seen)
    {
        public string? Pointer => Seen.Pointer;

        public Vector3 Position => Seen.Position!.Value;

        public Vector3 Normal => Seen.Normal!.Value;
    }
}
