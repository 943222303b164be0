using RayTracer.Description;
using RayTracer.Textures;

namespace RayTracer.Tests.Description;

public class NamedValuesTests
{
    [Theory]
    [InlineData("volPath")]
    [InlineData("volpath")]
    [InlineData("VOLPATH")]
    public void Names_are_found_whatever_their_case(string name) => Assert.Same(Integrator.VolPath, NamedValues.Of(typeof(Integrator))!.Find(name));

    [Fact]
    public void Names_of_enumerations_are_in_camelCase()
    {
        NamedValues values = NamedValues.Of(typeof(ShadingNormals))!;
        Assert.Equal(["mended", "literal"], values.Names);
        Assert.Equal(ShadingNormals.Literal, values.Find("Literal"));
        Assert.Null(values.Find("1"));
    }

    [Fact]
    public void Numbers_and_records_have_no_names() =>
        Assert.All([typeof(float), typeof(string), typeof(RenderDescription), typeof(TextureDescription)], type => Assert.Null(NamedValues.Of(type)));

    [Fact]
    public void A_value_that_is_added_is_found_by_its_own_type_and_by_its_base()
    {
        Assert.Equal(["round"], Form.Known.Names);
        Form.Known.Add(new Square("square"));
        Assert.Equal(["round", "square"], NamedValues.Of(typeof(Square))!.Names);
        Assert.Equal("square", NamedValues.NameOf(NamedValues.Of(typeof(Form))!.Find("SQUARE")!));
        Assert.Contains("another form \"round\"", Assert.Throws<ArgumentException>(() => Form.Known.Add(new Square("round"))).Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("")]
    [InlineData("Square")]
    [InlineData("two words")]
    [InlineData("größe")]
    public void Names_that_scene_files_cannot_have_are_refused(string name) => Assert.Throws<ArgumentException>(() => new Square(name));

    private abstract class Form(string name) : NamedValue(name)
    {
        public static Registry<Form> Known { get; } = new("form", f => [f.Name], new Square("round"));
    }

    private sealed class Square(string name) : Form(name);
}
