using RayTracer.Labs;

namespace Lab1;

/// <summary>The checks of lab 1. All cases are random, but always the same for the same name; of a wrong answer the simplest case is shown.</summary>
public static class Checks
{
    // Where rays only just meet or miss something, rounding decides: such cases are left out.
    private const double Clear = 1e-3;

    private const string WholeNumbers = "Your rays are right where width and height are even: in C#, 5 / 2 of whole numbers is 2, so divide by 2.0.";

    private const string WrongWeights = "Your areas weigh the wrong corners: the triangle of the ray with B and C is the share of A, the corner that is not on that edge.";

    // Rays that are aimed at edges: of the usual way to write a triangle, one of some hundred slips through.
    private const int Tries = 4000;

    [Check("the camera: rays", 1)]
    public static void Camera(CheckRun run) => run.Compare(new Trial<View>
    {
        Draw = View.Draw,
        Found = v => new Camera(v.Eye, v.LookAt, v.FieldOfView, v.Width, v.Height).RayThrough(v.X, v.Y),
        Expected = v => v.Ray(),
        Mistakes =
        [
            ("Your picture is upside down: rows are counted from the top, and the y of the world goes upwards.", v => v.Ray(up: -1)),
            ("Your rays are right but for their length: is the direction a unit vector?", v => v.Ray(isUnit: false)),
            ("Your field of view is too wide: it reaches from edge to edge, so that half of the angle is on either side of the middle.", v => v.Ray(angle: 2)),
            ("Your field of view lies across the width of the picture: it is the angle between the bottom and the top.", v => v.Ray(scale: (double)v.Height / v.Width)),
            ("Your pixels are no squares: both sides of one are 2·tan(θ/2) / height.", v => v.Ray(stretch: (double)v.Height / v.Width)),
            ("Your picture is the right one in a mirror: left and right have changed places.", v => v.Ray(right: -1)),
            ("Your rays lie half a pixel off: x is given in pixels, and the middle of the first pixel is 0.5 already.", v => v.Ray(shiftX: 0.5, shiftY: 0.5)),
            (WholeNumbers, v => v.Ray(shiftX: v.OddX, shiftY: v.OddY)),
            (WholeNumbers, v => v.Ray(shiftX: v.OddX)),
            (WholeNumbers, v => v.Ray(shiftY: v.OddY)),
        ],
    });

    [Check("the sphere by algebra", 2)]
    public static void SphereByAlgebra(CheckRun run) => run.Compare(new Trial<Ball>
    {
        Draw = draws => Ball.Draw(draws, isUnit: false),
        Found = b => Shapes.SphereByAlgebra(b.Ray, b.Center, b.Radius),
        Expected = b => b.Truth,
        Mistakes =
        [
            .. Ball.Mistakes,
            ("Your t is a times too large, with a = D·D: the solutions are (−b ± √(b² − 4ac)) / 2a, and a is 1 only where D has length 1.", b => b.Truth * Vector.Dot(b.Ray.Direction, b.Ray.Direction)),
        ],
        Show = b => b.Show(Shapes.SphereByAlgebra(b.Ray, b.Center, b.Radius)),
    });

    [Check("the sphere by geometry", 1)]
    public static void SphereByGeometry(CheckRun run) => run.Compare(new Trial<Ball>
    {
        Draw = draws => Ball.Draw(draws, isUnit: true),
        Found = b => Shapes.SphereByGeometry(b.Ray, b.Center, b.Radius),
        Expected = b => b.Truth,
        Mistakes = Ball.Mistakes,
        Show = b => b.Show(Shapes.SphereByGeometry(b.Ray, b.Center, b.Radius)),
    });

    [Check("the plane", 1)]
    public static void Plane(CheckRun run) => run.Compare(new Trial<Floor>
    {
        Draw = Floor.Draw,
        Found = f => Shapes.Plane(f.Ray, f.Point, f.Normal),
        Expected = f => f.T > 0 ? f.T : null,
        Mistakes =
        [
            ("You return planes that lie behind the eye: there t is below 0.", f => f.T),
            ("You see the plane from the side of its normal only: from behind it is there, too.", f => f.T > 0 && Vector.Dot(f.Ray.Direction, f.Normal) < 0 ? f.T : null),
        ],
        Show = f => RayScene.Show(
            "the plane", f.Ray, Shapes.Plane(f.Ray, f.Point, f.Normal), f.T > 0 ? f.T : null, RayScene.Shape("plane", "silver", ("point", f.Point), ("normal", f.Normal))),
    });

    [Check("the triangle by Cramer's rule", 2)]
    public static void Triangle(CheckRun run) => run.Compare(Corners.Trial("the triangle", Shapes.Triangle));

    [Check("the triangle without cracks", 2)]
    public static void WatertightTriangle(CheckRun run)
    {
        run.Compare(Corners.Trial(
            "the triangle without cracks", Shapes.WatertightTriangle,
            (WrongWeights, c => c.Weighted(c.V, c.W, c.U)),
            (WrongWeights, c => c.Weighted(c.U, c.V, c.W)),
            ("You return the mean of the three Z: where the ray is near to a corner, that corner's Z must weigh more.", c => c.Weighted(1, 1, 1))));
        Shell shell = new(run.Random);
        Ray[] missed = [.. shell.AtCorners().Where(shell.IsMissedBy(Shapes.WatertightTriangle))];
        if (missed.Length == shell.Corners)
        {
            run.Fail(
                "No ray at a corner meets any of the triangles around it: is a point on an edge outside for both sides? Compare with ≥ 0 and ≤ 0.", isRecognised: true,
                "a hit", "nothing", $"a ray from the origin at the corner {missed[0].Direction}");
        }

        missed = [.. missed, .. shell.AtEdges(run.Random, Tries).Where(shell.IsMissedBy(Shapes.WatertightTriangle))];
        if (missed.Length > 0)
        {
            run.Fail(
                $"There are cracks: {missed.Length} of {Tries + shell.Corners} rays at corners and edges of a closed shell slip out between two triangles. Both must compute the very same number for their common edge, but for its sign: use Along, and nothing that belongs to one triangle alone.",
                isRecognised: true, "a hit", "nothing", $"a ray from the origin along {missed[0].Direction}");
        }
    }

    [Check("a picture by all of it", 1)]
    public static void Picture(CheckRun run)
    {
        Room room = new(run.Random);
        run.Compare(Room.Width, Room.Height, room.Own, room.Reference);
    }

    private sealed record View(Vector Eye, Vector LookAt, double FieldOfView, int Width, int Height, double X, double Y)
    {
        public static View? Draw(Draws draws)
        {
            View view = new(
                draws.Point("eye", -5, 5), draws.Point("look at", -5, 5), draws.Number("field of view", 20, 80), draws.Whole("width", 2, 64), draws.Whole("height", 2, 64),
                draws.Number("x", 0, 64), draws.Number("y", 0, 64));
            Vector forward = view.LookAt - view.Eye;
            return view.X < view.Width && view.Y < view.Height && forward.Length > 0.5 && Math.Abs(forward.Unit.Y) < 0.9 ? view : null;
        }

        /// <summary>What is lost where half of the width is rounded downwards, in pixels.</summary>
        public double OddX => 0.5 * (Width % 2);

        /// <summary>What is lost where half of the height is rounded downwards, in pixels.</summary>
        public double OddY => 0.5 * (Height % 2);

        public Ray Ray(
            double up = 1, double right = 1, double angle = 1, double scale = 1, double stretch = 1, double shiftX = 0, double shiftY = 0, bool isUnit = true)
        {
            Vector forward = (LookAt - Eye).Unit;
            Vector toRight = Vector.Cross(forward, new(0, 1, 0)).Unit * right;
            Vector toTop = Vector.Cross(Vector.Cross(forward, new(0, 1, 0)).Unit, forward) * up;
            double half = scale * Math.Tan(angle * FieldOfView / 2 * Math.PI / 180);
            double s = stretch * ((2 * (X + shiftX)) - Width) / Height;
            double t = 1 - (2 * (Y + shiftY) / Height);
            Vector window = forward + (half * ((s * toRight) + (t * toTop)));
            return new(Eye, isUnit ? window.Unit : window);
        }
    }

    private sealed record Ball(Ray Ray, Vector Center, double Radius)
    {
        private readonly double _near = Root(Ray, Center, Radius, -1);
        private readonly double _far = Root(Ray, Center, Radius, 1);

        public static (string Sentence, Func<Ball, Answer?> Answer)[] Mistakes { get; } =
        [
            ("You return where the ray leaves the sphere: of two points the nearer one is seen.", b => b._far > 0 ? b._far : null),
            ("A ray that starts inside the sphere misses it: where the nearer point lies behind the origin, the farther one counts.", b => b._near > 0 ? b._near : null),
            ("You return points behind the origin of the ray: there t is below 0.", b => double.IsNaN(b._near) ? null : b._near),
            ("Your sphere lies on the other side of the ray's origin: b is 2·(O − C)·D, and with C − O it has the other sign.", b => b._far < 0 ? -b._far : b._near < 0 ? -b._near : null),
        ];

        public double? Truth
        {
            get
            {
                Hit hit = Hit.None();
                return new Sphere(Center, Radius).Intersect(Ray, ref hit) ? hit.Distance : null;
            }
        }

        // One of two rays meets the sphere, and one of ten starts inside.
        public static Ball? Draw(Draws draws, bool isUnit)
        {
            Vector center = draws.Point("centre", -2, 2);
            double radius = draws.Number("radius", 0.5, 2);
            Vector origin = draws.Point("origin", -3, 3);
            Vector aim = draws.Point("towards", -3, 3);
            Vector direction = aim - origin;
            if (direction.Length < 0.1)
            {
                return null;
            }

            Ball ball = new(new(origin, isUnit ? direction.Unit : direction), center, radius);
            Vector off = Vector.Cross(center - origin, direction.Unit);
            bool isClear = Math.Abs(off.Length - radius) > Clear && Math.Abs((origin - center).Length - radius) > Clear;
            return isClear ? ball : null;
        }

        public Exhibit Show(double? found) => RayScene.Show("the sphere", Ray, found, Truth, RayScene.Shape("sphere", "silver", ("center", Center), ("radius", Radius)));

        private static double Root(Ray ray, Vector center, double radius, int side)
        {
            Vector from = ray.Origin - center;
            double a = Vector.Dot(ray.Direction, ray.Direction);
            double half = Vector.Dot(from, ray.Direction);
            double c = Vector.Dot(from, from) - (radius * radius);
            return (-half + (side * Math.Sqrt((half * half) - (a * c)))) / a;
        }
    }

    private sealed record Floor(Ray Ray, Vector Point, Vector Normal)
    {
        public double T => Vector.Dot(Point - Ray.Origin, Normal) / Vector.Dot(Ray.Direction, Normal);

        public static Floor? Draw(Draws draws)
        {
            Floor floor = new(new(draws.Point("origin", -3, 3), draws.Direction("direction")), draws.Point("point of the plane", -3, 3), draws.Direction("normal"));
            return Math.Abs(Vector.Dot(floor.Ray.Direction, floor.Normal)) > 0.01 && Math.Abs(floor.T) > Clear ? floor : null;
        }
    }

    private sealed record Corners(Ray Ray, Vector A, Vector B, Vector C)
    {
        private readonly double[] _solution = Solve(Ray, A, B, C);

        public static Trial<Corners> Trial(
            string title, Func<Ray, Vector, Vector, Vector, double?> own, params IEnumerable<(string Sentence, Func<Corners, Answer?> Answer)> mistakes) => new()
            {
                Draw = Draw,
                Found = c => own(c.Ray, c.A, c.B, c.C),
                Expected = c => c.Answer(),
                Mistakes =
            [
                ("You have made a parallelogram: besides u ≥ 0 and v ≥ 0 the third coordinate, 1 − u − v, must not be below 0.", c => c.Answer(hasThird: false)),
                ("You have made a wedge without end: besides u ≥ 0 and v ≥ 0 the third coordinate, 1 − u − v, must not be below 0.", c => c.Answer(hasThird: false, hasEnd: false)),
                ("You return triangles that lie behind the eye: there t is below 0.", c => c.Answer(hasFront: false)),
                ("You see the triangle from one side only: a negative determinant is none to give up at.", c => c.Answer(side: 1)),
                ("You see the triangle from one side only: a positive determinant is none to give up at.", c => c.Answer(side: -1)),
                .. mistakes,
            ],
                Show = c => RayScene.Show(title, c.Ray, own(c.Ray, c.A, c.B, c.C), c.T, RayScene.Shape("triangle", "silver", ("a", c.A), ("b", c.B), ("c", c.C))),
            };

        // The barycentric coordinates of the corners: that of A is 1 − u − v.
        public double W => 1 - U - V;

        public double U => _solution[1];

        public double V => _solution[2];

        private double? T => _solution is [> 0 and var t, >= 0 and var u, >= 0 and var v] && u + v <= 1 ? t : null;

        private Answer? Answer(bool hasThird = true, bool hasEnd = true, bool hasFront = true, int side = 0)
        {
            (double t, double u, double v) = (_solution[0], _solution[1], _solution[2]);
            bool isInside = u >= 0 && v >= 0 && (hasThird ? u + v <= 1 : !hasEnd || (u <= 1 && v <= 1));
            bool isOnSide = side == 0 || side * Vector.Dot(Vector.Cross(B - A, C - A), Ray.Direction) < 0;
            return isInside && isOnSide && (t > 0 || !hasFront) ? t : null;
        }

        /// <summary>The mean of the corners as they are seen along the ray, by these weights.</summary>
        public Answer? Weighted(double ofA, double ofB, double ofC)
        {
            double t = ((ofA * Shapes.Along(Ray, A).Z) + (ofB * Shapes.Along(Ray, B).Z) + (ofC * Shapes.Along(Ray, C).Z)) / (ofA + ofB + ofC);
            return Math.Min(W, Math.Min(U, V)) >= 0 && t > 0 ? t : null;
        }

        private static Corners? Draw(Draws draws)
        {
            (Vector a, Vector b, Vector c) = (draws.Point("A", -3, 3), draws.Point("B", -3, 3), draws.Point("C", -3, 3));
            Vector origin = draws.Point("origin", -3, 3);

            // At a point of the plane, of which u and v are somewhere around the triangle; some of them lie behind.
            (double u, double v) = (draws.Number("u", -0.5, 1.5), draws.Number("v", -0.5, 1.5));
            Vector direction = a + (u * (b - a)) + (v * (c - a)) - origin;
            if (direction.Length < 0.1 || Vector.Cross(b - a, c - a).Length < 0.1)
            {
                return null;
            }

            Corners corners = new(new(origin, draws.Whole("points away from the triangle (where 3)", 0, 3) == 3 ? -direction.Unit : direction.Unit), a, b, c);
            double across = Math.Abs(Vector.Dot(Vector.Cross(b - a, c - a).Unit, direction.Unit));
            bool isClear = new[] { u, v, u + v - 1, u - 1, v - 1 }.All(x => Math.Abs(x) > Clear);
            return isClear && across > 0.05 ? corners : null;
        }

        // By the plane's normal, and areas within the plane.
        private static double[] Solve(Ray ray, Vector a, Vector b, Vector c)
        {
            Vector normal = Vector.Cross(b - a, c - a);
            double t = Vector.Dot(a - ray.Origin, normal) / Vector.Dot(ray.Direction, normal);
            Vector from = ray.At(t) - a;
            double square = Vector.Dot(normal, normal);
            return [t, Vector.Dot(Vector.Cross(from, c - a), normal) / square, Vector.Dot(Vector.Cross(b - a, from), normal) / square];
        }
    }
}
