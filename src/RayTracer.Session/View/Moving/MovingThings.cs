using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Shapes;

namespace RayTracer.Session;

/// <summary>Numbers of the things that pictures of a moving view show, the same in all of them, and how things have moved between two.</summary>
internal sealed class MovingThings
{
    private readonly Dictionary<string, int> _numbers = [];
    private readonly Dictionary<SurfaceName, int> _instances = [];
    private int[] _ofPrimitive = [];
    private GoodScene? _of;
    private DocumentPlace? _place;
    private Dictionary<int, Bounds> _places = [];
    private Dictionary<int, (Vector3 Scale, Vector3 Offset)> _moved = [];

    /// <summary>Turns to a scene.</summary>
    public SceneChange Turn(ViewportScene shown)
    {
        _moved = [];
        if (ReferenceEquals(_of, shown.Good))
        {
            return SceneChange.None;
        }

        SceneChange change = _of is null || !ReferenceEquals(_place, shown.Place) ? SceneChange.Other : SceneChange.Edited;
        (_of, _place) = (shown.Good, shown.Place);
        if (change == SceneChange.Other)
        {
            _numbers.Clear();
            _places = [];
        }

        _ofPrimitive = new int[shown.Scene.World.Count];
        _instances.Clear();
        FindPlaces(shown);
        return change;
    }

    /// <summary>The number of the thing that a surface belongs to; 0 for nothing.</summary>
    public int Of(ViewportScene shown, SurfaceName surface)
    {
        if (surface == SurfaceName.None)
        {
            return 0;
        }

        if (surface.Instance == 0)
        {
            ref int number = ref _ofPrimitive[surface.Primitive];
            return number > 0 ? number : number = Number(shown.PointerOf(surface) ?? surface.ToString());
        }

        lock (_instances)
        {
            SurfaceName name = new(0, surface.Instance);
            if (!_instances.TryGetValue(name, out int number))
            {
                _instances.Add(name, number = Number(shown.PointerOf(surface) ?? name.ToString()));
            }

            return number;
        }
    }

    /// <summary>How the things that have numbers so far have moved since the scene before.</summary>
    public ThingMoves Moves() => new(_moved, _numbers.Count + 1);

    private int Number(string name)
    {
        lock (_numbers)
        {
            if (!_numbers.TryGetValue(name, out int number))
            {
                _numbers.Add(name, number = _numbers.Count + 1);
            }

            return number;
        }
    }

    // A thing is taken to where its box was, and to its size.
    private void FindPlaces(ViewportScene shown)
    {
        const int most = 2000;
        Dictionary<int, Bounds> before = _places;
        _places = [];
        foreach (PlacedSurface surface in shown.Scene.Surfaces().Take(most))
        {
            if (shown.PointerOf(surface.Source) is { } pointer)
            {
                int thing = Number(pointer);
                _places[thing] = _places.TryGetValue(thing, out Bounds box) ? box.Union(surface.Bounds) : surface.Bounds;
            }
        }

        foreach ((int thing, Bounds now) in _places)
        {
            if (before.TryGetValue(thing, out Bounds then) && now != then && now.IsFinite && then.IsFinite)
            {
                Vector3 size = now.Maximum - now.Minimum;
                Vector3 scale = new(Ratio(then.Maximum.X - then.Minimum.X, size.X), Ratio(then.Maximum.Y - then.Minimum.Y, size.Y), Ratio(then.Maximum.Z - then.Minimum.Z, size.Z));
                _moved.Add(thing, (scale, ((then.Maximum + then.Minimum) * 0.5f) - ((now.Maximum + now.Minimum) * 0.5f * scale)));
            }
        }
    }

    private static float Ratio(float before, float now) => now > 0 && before > 0 ? before / now : 1;
}

/// <summary>What a scene is to the one before.</summary>
internal enum SceneChange
{
    /// <summary>The same, perhaps seen from elsewhere.</summary>
    None,

    /// <summary>The same document after an edit.</summary>
    Edited,

    /// <summary>Of another document, or the first.</summary>
    Other,
}
