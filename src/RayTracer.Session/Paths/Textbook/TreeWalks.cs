using System.Numerics;
using RayTracer.Textbook;
using Vector = RayTracer.Textbook.Vector;

namespace RayTracer.Session;

/// <summary>Shows how a ray of the picture finds its way through a tree of the textbook edition, node by node.</summary>
/// <param name="view">The picture.</param>
/// <param name="reading">Its scene in the textbook edition.</param>
public sealed class TreeWalks(PictureView view, TextbookReading reading) : ISessionPart<TreeWalks>
{
    // More would take long to build, and could not be distinguished.
    private const int MostShapes = 20_000;

    // Nobody steps further; a loop has as many steps as there are shapes.
    private const int MostSteps = 2000;
    private readonly Lock _lock = new();
    private (long Picture, string Tree, IShape[] Shapes, IAccelerator Built)? _built;

    /// <summary>The names of the trees.</summary>
    public static IReadOnlyList<string> Names { get; } = [.. Trees.All.Keys];

    /// <inheritdoc/>
    public static TreeWalks Of(StudioSession session) => new(session.View, session.Part<TextbookReading>());

    /// <summary>Follows a ray of a sample through a tree of all shapes that have an end; meshes are taken apart into triangles.</summary>
    /// <param name="x">The pixel's column.</param>
    /// <param name="y">The pixel's row.</param>
    /// <param name="sample">The sample's number.</param>
    /// <param name="ray">The number of the ray on the path, from 1 for that of the camera.</param>
    /// <param name="tree">One of <see cref="Names"/>.</param>
    /// <exception cref="SessionException">There is no such ray or tree, or the textbook edition lacks something that the scene has.</exception>
    public TreeWalk Walk(int x, int y, int sample, int ray, string tree)
    {
        ViewportScene shown = view.RequireShown();
        if (!Trees.All.TryGetValue(tree, out Func<IReadOnlyList<IShape>, IAccelerator>? build))
        {
            throw new SessionException($"There is no tree \"{tree}\": there are {string.Join(", ", Names)}.", SessionFault.Missing);
        }

        PathInspector.Check(shown, x, y, sample, 1);
        ViewportScene textbook = shown.Settings.Edition is null ? shown with { Settings = shown.Settings with { Edition = ViewSettings.Editions[1] } } : shown;
        Renderer renderer = reading.Read(textbook) ?? throw new SessionException("The scene has not been read yet.", SessionFault.Missing);
        List<RayNotes.Vertex> vertices = new TextbookPaths(textbook, renderer).Follow(x, y, sample, out _).Vertices;
        Textbook.Ray along = vertices[Math.Clamp(ray, 1, vertices.Count) - 1].Ray;
        return Walk(along, shown, tree, BuiltFor(shown, renderer, tree, build));
    }

    private static TreeWalk Walk(in Textbook.Ray along, ViewportScene shown, string name, (IShape[] Shapes, IAccelerator Tree) built)
    {
        List<TreeStep> steps = [];
        Textbook.Hit hit = Textbook.Hit.None();
        hit.Watch = (corners, tests) =>
        {
            if (steps.Count < MostSteps)
            {
                steps.Add(new(Lines(corners), tests));
            }
        };
        bool isHit = built.Tree.Intersect(along, ref hit);
        double length = isHit ? hit.Distance : 2 * shown.Extent.Size;
        return new(name, built.Shapes.Length, hit.Visits, hit.Tests, Point(along.Origin), Point(along.At(length)), isHit, steps);
    }

    private (IShape[] Shapes, IAccelerator Tree) BuiltFor(ViewportScene shown, Renderer renderer, string name, Func<IReadOnlyList<IShape>, IAccelerator> build)
    {
        lock (_lock)
        {
            if (_built is { } built && built.Picture == shown.Picture && built.Tree == name)
            {
                return (built.Shapes, built.Built);
            }

            IShape[] shapes = [.. renderer.Scene.Things.SelectMany(t => t.Shape.Parts).Where(s => s.Bounds.IsFinite).Take(MostShapes + 1)];
            if (shapes.Length > MostShapes)
            {
                throw new SessionException($"The scene has more than {MostShapes:N0} shapes and triangles, too many to be looked at one by one.");
            }

            IAccelerator tree = build(shapes);
            _built = (shown.Picture, name, shapes, tree);
            return (shapes, tree);
        }
    }

    // The edges of a box, by its eight corners; else a polygon.
    private static IReadOnlyList<IReadOnlyList<Vector3>> Lines(Vector[] corners)
    {
        if (corners.Length != 8)
        {
            return corners.Length == 0 ? [] : [[.. corners.Append(corners[0]).Select(Point)]];
        }

        return
        [
            .. from i in Enumerable.Range(0, 8)
               from axis in new[] { 1, 2, 4 }
               where (i & axis) == 0
               select new[] { Point(corners[i]), Point(corners[i | axis]) },
        ];
    }

    private static Vector3 Point(Vector v) => new((float)v.X, (float)v.Y, (float)v.Z);
}

/// <summary>The way of a ray through a tree.</summary>
/// <param name="Tree">The name of the tree.</param>
/// <param name="Shapes">The number of shapes in it.</param>
/// <param name="Visits">The number of nodes that were visited.</param>
/// <param name="Tests">The number of shapes that the ray was tested against.</param>
/// <param name="Start">Where the ray starts.</param>
/// <param name="End">Where it meets something, or far out.</param>
/// <param name="IsHit">Whether it meets something.</param>
/// <param name="Steps">The nodes, in the order of the visits; the first two thousand.</param>
public sealed record TreeWalk(string Tree, int Shapes, int Visits, int Tests, Vector3 Start, Vector3 End, bool IsHit, IReadOnlyList<TreeStep> Steps);

/// <summary>A node that a ray visits.</summary>
/// <param name="Lines">Its box, or the plane that cuts it, as lines in the world; nothing where it has no place of its own.</param>
/// <param name="Tests">The shapes that the ray had been tested against before.</param>
public sealed record TreeStep(IReadOnlyList<IReadOnlyList<Vector3>> Lines, int Tests);
