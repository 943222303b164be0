using System.Reflection;
using System.Reflection.Emit;
using RayTracer.Description;

namespace RayTracer.Tests.Description;

/// <summary>A thing of a set that is open for plug-ins.</summary>
public abstract class Shelf(string name) : NamedValue(name)
{
    /// <summary>All of them.</summary>
    public static Registry<Shelf> Known { get; } = new("shelf", s => [s.Name]);
}

/// <summary>A thing of another open set.</summary>
public abstract class Drawer(string name) : NamedValue(name)
{
    /// <summary>All of them.</summary>
    public static Registry<Drawer> Known { get; } = new("drawer", d => [d.Name]);
}

/// <summary>Assemblies made for the tests, which derive classes from <see cref="Shelf"/> and <see cref="Drawer"/>.</summary>
public class PluginsTests
{
    [Fact]
    public void All_that_an_assembly_defines_is_added()
    {
        Assembly plugin = Made("Both", (typeof(Shelf), "upper"), (typeof(Drawer), "flat"));
        Plugins.Add(plugin);
        Assert.NotNull(Shelf.Known.Find("upper"));
        Type flat = Drawer.Known.Find("flat")!.GetType();
        Assert.Equal("Both 1.2.3.4", Plugins.OriginOf(flat));
        Assert.Null(Plugins.OriginOf(typeof(SceneDescription)));
        Assert.Contains(plugin, Plugins.Added);
    }

    [Theory]
    [InlineData("oak", "taken", "There is another drawer \"taken\"")]
    [InlineData("oak", "tAKEN", "There is another drawer \"tAKEN\"")]
    [InlineData("oak", "Two words", "\"Two words\" is no name for scene files")]
    [InlineData("taken", "deep", "There is another shelf \"taken\"")]
    public void Where_one_name_is_refused_nothing_is_added(string shelf, string drawer, string message)
    {
        _ = s_taken.Value;
        Assembly plugin = Made("Refused", (typeof(Shelf), shelf), (typeof(Drawer), drawer));
        Assert.Contains(message, Assert.Throws<PluginException>(() => Plugins.Add(plugin)).Message, StringComparison.Ordinal);
        Assert.Null(Shelf.Known.Find("oak"));
        Assert.Null(Drawer.Known.Find("deep"));
        Assert.DoesNotContain(plugin, Plugins.Added);
    }

    [Fact]
    public void Two_things_of_one_assembly_cannot_have_one_name()
    {
        Assembly plugin = Made("Twice", (typeof(Shelf), "twin"), (typeof(Shelf), "twin"));
        Assert.Contains("There is another shelf \"twin\"", Assert.Throws<PluginException>(() => Plugins.Add(plugin)).Message, StringComparison.Ordinal);
        Assert.Null(Shelf.Known.Find("twin"));
    }

    private static readonly Lazy<bool> s_taken = new(() =>
    {
        Plugins.Add(Made("First", (typeof(Shelf), "taken"), (typeof(Drawer), "taken")));
        return true;
    });

    // An assembly with one class for each thing, whose constructor passes the name on.
    private static Assembly Made(string name, params (Type Base, string Name)[] things)
    {
        PersistedAssemblyBuilder assembly = new(new(name) { Version = new(1, 2, 3, 4) }, typeof(object).Assembly);
        ModuleBuilder module = assembly.DefineDynamicModule(name);
        foreach ((int number, (Type ancestor, string called)) in things.Index())
        {
            TypeBuilder type = module.DefineType($"{name}.Thing{number}", TypeAttributes.Public | TypeAttributes.Sealed, ancestor);
            ILGenerator code = type.DefineConstructor(MethodAttributes.Public, CallingConventions.Standard, []).GetILGenerator();
            code.Emit(OpCodes.Ldarg_0);
            code.Emit(OpCodes.Ldstr, called);
            code.Emit(OpCodes.Call, ancestor.GetConstructor(BindingFlags.NonPublic | BindingFlags.Instance, [typeof(string)])!);
            code.Emit(OpCodes.Ret);
            type.CreateType();
        }

        using MemoryStream file = new();
        assembly.Save(file);
        return Assembly.Load(file.ToArray());
    }
}
