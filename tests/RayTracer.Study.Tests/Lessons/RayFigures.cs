using System.Xml.Linq;
using RayTracer.Textbook;
using static RayTracer.Study.Tests.Lessons.Figure;

namespace RayTracer.Study.Tests.Lessons;

/// <summary>Drawings of the lessons on rays, shapes and trees, by the functions of the textbook edition.</summary>
internal static class RayFigures
{
    /// <summary>From the side: an eye, a window of nine pixels, and where the rays through their middles end.</summary>
    public static XDocument Camera()
    {
        const int Rows = 9;
        Figure figure = new(660, 330);
        PerspectiveCamera camera = new(default, new(0, 0, -1), new(1, 0, 0), new(0, 1, 0), 1, Rows, 2 * Math.Tan(Math.PI * 25 / 180) / Rows, new Pinhole(), 1);
        (IShape Shape, string Colour)[] things = [(new Sphere(new(0, 0.3, -4.2), 1.1), Blue), (new Plane(new(0, -1, 0), new(1, 0, 0), new(0, 0, -1)), Amber)];
        (double, double) At(Vector p) => (50 - (98 * p.Z), 165 - (98 * p.Y));

        figure.Line(At(new(0, -1, 0)), At(new(0, -1, -6.1)), Amber, 3);
        figure.Circle(At(new(0, 0.3, -4.2)), 1.1 * 98, Blue, "#e3eff7", 2.5);
        for (int row = 0; row < Rows; row++)
        {
            Ray ray = camera.RayThrough(0.5, row + 0.5, new IndependentSampler());
            Hit hit = Hit.None(6.2);
            string colour = Faint;
            foreach ((IShape shape, string own) in things)
            {
                colour = shape.Intersect(ray, ref hit) ? own : colour;
            }

            figure.Line(At(default), At(ray.At(hit.Distance)), colour == Faint ? Faint : colour, 1.2);
            if (colour != Faint)
            {
                figure.Dot(At(ray.At(hit.Distance)), colour);
            }

            // The pixel, between the rays through its edges.
            double side = 98 * 2 * Math.Tan(Math.PI * 25 / 180) / Rows;
            figure.Rectangle(144, 165 + (side * (row - (Rows / 2.0))), 8, side, colour == Faint ? "#eaf1f6" : colour, Ink);
        }

        figure.Dot(At(default), Ink, 5);
        figure.Text("eye", (44, 192));
        figure.Text("window: nine pixels", (90, 88));
        figure.Text("the sky: no hit", (600, 22));
        figure.Text("floor", (620, 285));
        figure.Text("sphere", (462, 142));
        return figure.Document;
    }

    /// <summary>A ray through a sphere: both roots, the point in the middle between them, and the right triangle of the geometric way.</summary>
    public static XDocument Sphere()
    {
        Figure figure = new(660, 320);
        (Vector centre, double radius) = (new(400, 140, 0), 115);
        Sphere sphere = new(centre, radius);
        Ray ray = new(new(60, 230, 0), new Vector(1, -0.115, 0).Unit);
        Hit first = Hit.None();
        Hit second = Hit.None();
        sphere.Intersect(ray, ref first);
        sphere.Intersect(new(ray.At(first.Distance + 1), ray.Direction), ref second);
        double middle = Vector.Dot(centre - ray.Origin, ray.Direction);
        double far = first.Distance + 1 + second.Distance;
        (double, double) At(Vector p) => (p.X, p.Y);
        Vector Below(double t, double by) => ray.At(t) + new Vector(0, by, 0);

        figure.Circle(At(centre), radius, Blue, "#e3eff7", 2);
        figure.Arrow(At(ray.Origin), At(ray.At(570)), Ink);
        figure.Line(At(centre), At(ray.At(middle)), Red, 2);
        figure.Line(At(centre), At(ray.At(first.Distance)), Green, 2);
        figure.Line(At(ray.At(first.Distance)), At(ray.At(middle)), Purple, 3);
        figure.Line(At(ray.Origin), At(centre), Faint, 1.5, "5 4");
        Array.ForEach([ray.Origin, centre, ray.At(middle)], p => figure.Dot(At(p)));
        Array.ForEach([ray.At(first.Distance), ray.At(far)], p => figure.Dot(At(p), Blue, 5));
        figure.Text("O", At(ray.Origin + new Vector(-8, 20, 0)));
        figure.Text("C", At(centre + new Vector(12, -6, 0)), "start");
        figure.Text("t₀", At(Below(first.Distance, 26) + new Vector(-10, 0, 0)), colour: Blue, isBold: true);
        figure.Text("t₁", At(Below(far, 26) + new Vector(10, 0, 0)), colour: Blue, isBold: true);
        figure.Text("t_ca", At(Below(middle, 24)));
        figure.Text("d", At(centre + new Vector(12, 34, 0)), "start", Red, isBold: true);
        figure.Text("r", At(centre + new Vector(-62, 12, 0)), colour: Green, isBold: true);
        figure.Text("t_hc", At(Below((first.Distance + middle) / 2, -8)), colour: Purple, isBold: true);
        figure.Text("L = C − O", (205, 168));
        figure.Text("t_ca = L · D", (20, 297), "start");
        figure.Text("d² = L² − t_ca²", (122, 297), "start", Red);
        figure.Text("t_hc² = r² − d²", (262, 297), "start", Purple);
        figure.Text("t₀ = t_ca − t_hc,  t₁ = t_ca + t_hc", (396, 297), "start", Blue);
        return figure.Document;
    }

    /// <summary>Barycentric coordinates as shares of the area, of a point inside and of one outside.</summary>
    public static XDocument Barycentric()
    {
        Figure figure = new(660, 300);
        for (int i = 0; i < 2; i++)
        {
            Vector shift = new(330 * i, 0, 0);
            Vector[] corners = [new Vector(35, 225, 0) + shift, new Vector(265, 245, 0) + shift, new Vector(165, 45, 0) + shift];
            Vector point = shift + (i == 0 ? new Vector(180, 165, 0) : new Vector(275, 120, 0));
            MeshTriangle triangle = new(corners, 0, 1, 2);
            (double b, double c) = triangle.Barycentric(point);
            (double, double) At(Vector p) => (p.X, p.Y);
            string[] colours = [Blue, Red, Green];
            for (int corner = 0; corner < 3; corner++)
            {
                figure.Polygon([At(point), At(corners[(corner + 1) % 3]), At(corners[(corner + 2) % 3])], colours[corner], opacity: 0.3);
            }

            figure.Polygon(corners.Select(At), "none", Ink);
            Array.ForEach(corners, p => figure.Line(At(p), At(point), Ink, 1, "4 3"));
            figure.Dot(At(point), Ink, 4);
            figure.Text("A", At(corners[0] + new Vector(-12, 12, 0)), colour: Blue, isBold: true);
            figure.Text("B", At(corners[1] + new Vector(12, 14, 0)), colour: Red, isBold: true);
            figure.Text("C", At(corners[2] + new Vector(0, -10, 0)), colour: Green, isBold: true);
            figure.Text("P", At(point + new Vector(12, -8, 0)), isBold: true);
            figure.Text(FormattableString.Invariant($"α = {1 - b - c:0.00}").Replace('-', '−'), (55 + shift.X, 283), "start", Blue);
            figure.Text(FormattableString.Invariant($"β = {b:0.00}").Replace('-', '−'), (135 + shift.X, 283), "start", Red);
            figure.Text(FormattableString.Invariant($"γ = {c:0.00}").Replace('-', '−'), (215 + shift.X, 283), "start", Green);
        }

        return figure.Document;
    }

    /// <summary>Two maps in both orders, and normals of a stretched circle.</summary>
    public static XDocument Transforms()
    {
        Figure figure = new(660, 320);
        Vector[] house = [new(0, 0, 0), new(1, 0, 0), new(1, 0.8, 0), new(0.5, 1.3, 0), new(0, 0.8, 0)];
        Transform turn = Transform.Rotation(new(0, 0, 1), 45);
        Transform shift = Transform.Translation(new(1.5, 0, 0));
        (string Title, Transform Map)[] orders = [("first turned, then moved", shift.After(turn)), ("first moved, then turned", turn.After(shift))];
        for (int i = 0; i < 2; i++)
        {
            double left = 65 + (205 * i);
            (double, double) At(Vector p) => (left + (55 * p.X), 245 - (55 * p.Y));
            figure.Arrow(At(new(-0.7, 0, 0)), At(new(2.7, 0, 0)), Faint);
            figure.Arrow(At(new(0, -0.5, 0)), At(new(0, 3, 0)), Faint);
            figure.Polygon(house.Select(At), "#eeeeee", Faint);
            figure.Polygon(house.Select(orders[i].Map.Point).Select(At), Blue, Blue, 0.3);
            figure.Text(orders[i].Title, (left + 55, 300));
        }

        Transform stretch = Transform.Scaling(new(2, 1, 1));
        (double, double) There(Vector p) => (552 + (36 * p.X), 170 - (36 * p.Y));
        IEnumerable<Vector> circle = Enumerable.Range(0, 73).Select(i => Transform.Rotation(new(0, 0, 1), 5 * i).Direction(new(1, 0, 0)));
        figure.Polyline(circle.Select(stretch.Point).Select(There), Ink);
        foreach (int degrees in new[] { 25, 50, 75, 105, 130, 155 })
        {
            Vector normal = Transform.Rotation(new(0, 0, 1), degrees).Direction(new(1, 0, 0));
            Vector foot = stretch.Point(normal);
            figure.Arrow(There(foot), There(foot + stretch.Direction(normal).Unit), Red, 1.2);
            figure.Arrow(There(foot), There(foot + stretch.Normal(normal).Unit), Green, 1.8);
        }

        figure.Text("M⁻ᵀ n", (550, 268), colour: Green, isBold: true);
        figure.Text("M n: not perpendicular", (550, 300), colour: Red);
        return figure.Document;
    }

    /// <summary>How many visits and tests a ray takes, of a loop, a grid and two trees, against the number of spheres.</summary>
    public static XDocument Trees()
    {
        (string Name, string Colour, Func<IReadOnlyList<IShape>, IAccelerator> Build)[] methods =
        [
            ("plain loop", Ink, shapes => new PlainLoop(shapes)),
            ("BVH, median", Amber, shapes => new BoundingVolumes(shapes, isHalved: true)),
            ("BVH, areas", Blue, shapes => new BoundingVolumes(shapes)),
            ("kd-tree", Green, shapes => new KdTree(shapes)),
            ("uniform grid", Purple, shapes => new UniformGrid(shapes)),
        ];
        int[] counts = [10, 32, 100, 316, 1000, 3162, 10000];
        return SvgChart.Draw([new("Work of a ray", "spheres", "visits of nodes and tests of shapes, mean",
            [.. methods.Select(m => new ChartSeries(m.Name, m.Colour, [.. counts.Select(n => ((double)n, Work(m.Build, n)))], Fit: null) { IsJoined = true })], IsLogarithmic: true)
            { HasLegendAside = true }]);
    }

    // Spheres that fill the same share of a cube, however many; rays between random points of it.
    private static double Work(Func<IReadOnlyList<IShape>, IAccelerator> build, int count)
    {
        IndependentSampler random = new(1);
        Vector Point() => new(random.Next(), random.Next(), random.Next());
        IAccelerator tree = build([.. Enumerable.Range(0, count).Select(_ => new Sphere(Point(), 0.3 / Math.Cbrt(count)))]);
        double work = 0;
        const int Rays = 200;
        for (int i = 0; i < Rays; i++)
        {
            Vector origin = Point();
            Hit hit = Hit.None();
            tree.Intersect(new(origin, (Point() - origin).Unit), ref hit);
            work += hit.Visits + hit.Tests;
        }

        return work / Rays;
    }

    /// <summary>Which of many disks a ray is tested against in a tree of boxes.</summary>
    public static XDocument Asked()
    {
        const int Count = 120;
        Figure figure = new(660, 330);
        IndependentSampler random = new(7);
        Counted[] shapes = [.. Enumerable.Range(0, Count).Select(_ => new Counted(new(20 + (620 * random.Next()), 40 + (270 * random.Next()), 0), 5 + (7 * random.Next())))];
        BoundingVolumes tree = new(shapes);

        // Of some rays, one that comes near to several disks.
        Hit Trace(Ray from)
        {
            Hit nearest = Hit.None(640);
            tree.Intersect(from, ref nearest);
            return nearest;
        }

        Ray ray = Enumerable.Range(0, 20).Select(i => new Ray(new(12, 80 + (10 * i), 0), new Vector(1, (10 - i) / 100.0, 0).Unit)).MaxBy(r => (Trace(r).Tests, Trace(r).Distance));
        Array.ForEach(shapes, s => s.IsAsked = false);
        Hit hit = Trace(ray);
        foreach (Counted shape in shapes)
        {
            figure.Circle((shape.Centre.X, shape.Centre.Y), shape.Radius, shape.IsAsked ? Red : "#9a9a9a", shape.IsAsked ? "#f6d9c8" : "#eeeeee");
        }

        Vector end = ray.At(hit.Distance);
        figure.Arrow((ray.Origin.X, ray.Origin.Y), (end.X, end.Y), Blue, 2);
        figure.Text($"{Count} disks: {hit.Tests} are tested (red), after visits of {hit.Visits} of the tree's {tree.NodeCount} boxes", (330, 24));
        return figure.Document;
    }

    /// <summary>Two triangles that pass through each other: painted one after the other, and by the nearest at each pixel.</summary>
    public static XDocument Visibility()
    {
        const int Columns = 24;
        const int Rows = 16;
        Figure figure = new(660, 270);
        Vector[] points = [new(1, 2, 2), new(22.5, 6, 8), new(2, 14.5, 2.5), new(22.5, 1.5, 1.5), new(23, 14, 3), new(2, 9, 8)];
        Face[] faces = [new(points[0], points[1], points[2], Rgb.White), new(points[3], points[4], points[5], Rgb.White)];

        // Columns and rows are those of the points; depths are up to 10.
        Matrix camera = new(new(2.0 / Columns, 0, 0, -1), new(0, -2.0 / Rows, 0, 1), new(0, 0, 0.1, 0), new(0, 0, 0, 1));
        for (int panel = 0; panel < 2; panel++)
        {
            Rasterizer rasterizer = new(Columns, Rows) { IsPainter = panel == 0 };
            rasterizer.Draw(faces, camera);
            for (int i = 0; i < Columns * Rows; i++)
            {
                string colour = rasterizer.Visible[i] < 0 ? "#f2f2f2" : rasterizer.Visible[i] == 0 ? Blue : Amber;
                figure.Rectangle(25 + (320 * panel) + (12 * (i % Columns)), 20 + (12 * (i / Columns)), 12, 12, colour, "#ffffff");
            }
        }

        figure.Text("painter: the second triangle covers the first", (169, 245));
        figure.Text("z-buffer or rays: the nearest at each pixel", (489, 245));
        return figure.Document;
    }

    // A sphere that notes whether it was asked.
    private sealed class Counted(Vector centre, double radius) : IShape
    {
        private readonly Sphere _sphere = new(centre, radius);

        public Vector Centre => centre;

        public double Radius => radius;

        public bool IsAsked { get; set; }

        public Bounds Bounds => _sphere.Bounds;

        public double Area => _sphere.Area;

        public bool Intersect(in Ray ray, ref Hit hit)
        {
            IsAsked = true;
            return _sphere.Intersect(ray, ref hit);
        }

        public void Describe(in Ray ray, ref Hit hit) => _sphere.Describe(ray, ref hit);

        public SurfacePoint PointAt((double U, double V) random) => _sphere.PointAt(random);
    }
}
