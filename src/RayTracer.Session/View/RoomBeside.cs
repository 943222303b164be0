using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>
/// Finds room for a new thing: where it cuts into nothing, as near as can be; on what was pointed at, else on something level that is seen there, else on
/// anything.
/// </summary>
/// <param name="place">The place that was pointed at.</param>
/// <param name="late">What is in the text, and not in the picture yet; null for nothing.</param>
internal sealed class RoomBeside(PlaceInView place, Scene? late)
{
    // Rings of pixels around the one that was pointed at: as far apart as a quarter of a new thing, which is an eighth of the picture.
    private const int Rings = 16;
    private const int Directions = 12;
    private const float Step = 1f / 32;

    // In sizes: what stands farther away is not where somebody wanted it.
    private const float Reach = 5;

    // The least cosine between the normals of places that are taken for one ground, and between that of what is level and the upward direction.
    private const float Alike = 0.95f;

    private static readonly Vector2[] _directions = Around();
    private readonly RayProbe[] _others = late is null ? [new(place.Shown.Scene)] : [new(place.Shown.Scene), new(late)];

    /// <summary>By what the body is moved from the place: not at all where it cuts into nothing, or where there is no room.</summary>
    /// <param name="body">The body.</param>
    /// <param name="put">What moves it to the place.</param>
    public Vector3 For(NewBody body, Vector3 put)
    {
        if (place.Ground is not { } up || IsFree(body, put))
        {
            return default;
        }

        string? thing = Picking.At(place.Shown, place.Pixel.X, place.Pixel.Y).Pointer;
        PickResult[] seen = [.. Enumerable.Range(1, Rings).SelectMany(Ring)];
        Vector3 upright = CameraController.Local(place.Shown).Inverse().Vector(place.Shown.Camera.Up).Unit();

        // The ground rather than what stands on it, whose tops are level, too.
        float Height(PickResult s) => MathF.Floor(s.Position!.Value.Dot(upright) / (place.View.Size / 4));
        return On(seen.Where(s => s.Pointer == thing && s.Normal!.Value.Dot(up) > Alike), body, put)
            ?? On(seen.Where(s => s.Normal!.Value.Dot(upright) > Alike).OrderBy(Height), body, put)
            ?? On(seen, body, put)
            ?? default;
    }

    private Vector3? On(IEnumerable<PickResult> places, NewBody body, Vector3 put)
    {
        Vector3 up = place.Ground!.Value;
        float below = place.Below(body, up);
        foreach (PickResult seen in places)
        {
            Vector3 normal = seen.Normal!.Value;
            bool isLevel = normal.Dot(up) > 1 - 1e-5f;
            Vector3 by = seen.Position!.Value - place.Point + (isLevel ? default : (normal * place.Below(body, normal)) - (up * below));

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

    // What is seen around the pixel, the nearest first.
    private PickResult[] Ring(int ring)
    {
        RenderDescription render = place.Shown.Scene.Render;
        float radius = ring * Step * render.Height;
        return [.. _directions.Select(d => place.Pixel + (radius * d))
            .Where(p => p.X >= 0 && p.Y >= 0 && p.X < render.Width && p.Y < render.Height)
            .Select(p => Picking.At(place.Shown, p.X, p.Y)).Where(s => s.Position is { } at && (at - place.Point).Norm() < Reach * place.View.Size)
            .OrderBy(s => (s.Position!.Value - place.Point).Norm())];
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
}
