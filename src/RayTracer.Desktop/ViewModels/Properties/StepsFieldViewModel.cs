using System.Text.Json.Nodes;
using System.Windows.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>A list of records, such as the steps of a transform.</summary>
internal sealed class StepsFieldViewModel(PanelContext context, CatalogueParameter parameter, string pointer, CatalogueType type) : FieldViewModel(context, parameter, pointer)
{
    /// <summary>The records.</summary>
    public IReadOnlyList<StepViewModel> Steps { get; private set; } = [];

    /// <summary>What the button says that adds one.</summary>
    public string AddText => SessionTexts.Of("panel.addStep", Label);

    /// <summary>Adds one.</summary>
    public ICommand Add => new ActionCommand(() =>
    {
        JsonArray list = [.. (Written as JsonArray ?? []).Select(s => s?.DeepClone()), ParameterValues.Fresh(type)];
        Write(list);
    });

    /// <inheritdoc/>
    protected override void Shown()
    {
        JsonArray written = Written as JsonArray ?? [];
        if (written.Count != Steps.Count)
        {
            Steps = [.. written.Select((_, i) => Step(i))];
        }

        for (int i = 0; i < Steps.Count; i++)
        {
            Steps[i].Record.Show(written[i]);
        }
    }

    private StepViewModel Step(int i)
    {
        string at = JsonPointer.Append(Pointer, i);
        return new(
            SessionTexts.Of("panel.step", i + 1), SessionTexts.Of("panel.removeStep", i + 1), new RecordViewModel(Context, type, at, []), new ActionCommand(() => Context.Delete(at)));
    }
}
