using System.Reflection;
using RayTracer.Imaging;
using RayTracer.Import;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Repository.Tests.Packages;

/// <summary>The public surface of the packages, one line a member, in PublicApi.txt of each project: whatever changes it is seen in a review.</summary>
public class PublicApiTests
{
    [Theory]
    [InlineData("RayTracer", typeof(Scene))]
    [InlineData("RayTracer.Imaging", typeof(ImageFile))]
    [InlineData("RayTracer.Scenes", typeof(SceneLoader))]
    [InlineData("RayTracer.Import", typeof(Importers))]
    [InlineData("RayTracer.Textbook", typeof(Textbook.Scene))]
    [InlineData("RayTracer.Adapters", typeof(Adapters.TextbookMaterialDescription))]
    public void The_committed_list_is_the_public_surface(string project, Type type) =>
        RepositoryFolder.AssertHolds(ProjectFolder.PathOf("src", project, "PublicApi.txt"), string.Join('\n', PublicApi.Of(type.Assembly)) + "\n");

    [Fact]
    public void The_list_has_what_others_see_and_nothing_else()
    {
        string name = typeof(Sample<>).FullName!.Replace('+', '.').Replace("`1", "<T>", StringComparison.Ordinal);
        Assert.Equal(
            [
                $"class {name} : IDisposable where T : class, new()",
                $"{name}.Dispose() : void",
                $"{name}.Item[int] : T {{ get; }}",
                $"{name}.Limit : int = 3",
                $"{name}.Sample(string name, float? scale = null)",
                $"{name}.Scale : float? {{ get; init; }}",
                $"{name}.protected virtual Seen(in T thing, out List<int[]> all) : bool",
                $"{name}.static Add(Sample<T> a, params string[] names) : Sample<T>",
                $"{name}.static operator +(Sample<T> a, Sample<T> b) : Sample<T>",
            ],
            PublicApi.Of(typeof(Sample<>)));
        Assert.Equal(["enum RayTracer.Repository.Tests.Packages.PublicApiTests.Size : byte", "RayTracer.Repository.Tests.Packages.PublicApiTests.Size.Large = 2"], PublicApi.Of(typeof(Size)));
        Assert.Equal(
            ["record struct RayTracer.Repository.Tests.Packages.PublicApiTests.Place", "RayTracer.Repository.Tests.Packages.PublicApiTests.Place.Place(int X)", "RayTracer.Repository.Tests.Packages.PublicApiTests.Place.X : int { get; set; }"],
            PublicApi.Of(typeof(Place)));
    }

    public enum Size : byte
    {
        Large = 2,
    }

    public record struct Place(int X);

    public class Sample<T> : IDisposable
        where T : class, new()
    {
        public const int Limit = 3;

        private int _hidden;

        public Sample(string name, float? scale = null) => (_hidden, Scale) = (name.Length, scale);

        public float? Scale { get; init; }

        internal int Hidden => _hidden++;

        public T this[int index] => new();

        public static Sample<T> operator +(Sample<T> a, Sample<T> b) => a;

#pragma warning disable CA1000 // A static member of a generic type is one of the kinds that are listed.
        public static Sample<T> Add(Sample<T> a, params string[] names) => a;
#pragma warning restore CA1000

        public void Dispose() => GC.SuppressFinalize(this);

        public override string ToString() => "";

        protected virtual bool Seen(in T thing, out List<int[]> all)
        {
            all = [];
            return Hidden > 0;
        }
    }
}
