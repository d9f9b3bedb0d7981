-- | The film that a scene file and options make together.
module BlackHole.Cli.AnimationScene
  ( loadFilm,
    resolveFilm,
    frameFaults,
    maximumFaults,
  )
where

import BlackHole.Animation.Animation
import BlackHole.Animation.AnimationFile
import BlackHole.Animation.Progress (frameRanges)
import BlackHole.Cli.SceneOptions
import BlackHole.Scene.File.Yaml
import BlackHole.Scene.Problem
import BlackHole.Scene.Scene (Scene)
import qualified Data.ByteString as Bytes
import Data.Either (fromRight)
import Data.Foldable (fold)
import Data.List (sortOn)
import qualified Data.Map.Strict as Map

-- | The film that the options ask for, given the bytes of the scene file, or one line for
-- each mistake in its scene and its section @animation@. 'Nothing' if there is no such
-- section. Does not validate the scenes of the frames; see 'frameFaults'.
resolveFilm :: SceneOptions -> Maybe Bytes.ByteString -> Either [String] (Maybe Film)
resolveFilm options bytes = case (resolveScene options bytes, section) of
  (Left problems, _) -> Left (problems ++ sectionFaults)
  (_, Just (_, _ : _)) -> Left sectionFaults
  (Right scene, Just (film, [])) -> Right (Just (film scene))
  (Right _, Nothing) -> Right Nothing
  where
    -- A file that is not YAML is reported with the scene.
    section = bytes >>= fromRight Nothing . parseYaml >>= readAnimation
    sectionFaults =
      [ concat [fold (sceneFile options), ":", show line, ": ", renderProblem problem]
        | (line, problem) <- sortOn fst (maybe [] snd section)
      ]

-- | The film that the options ask for, like 'resolveFilm', or without a section
-- @animation@ its single scene. Reads the file, and warns of former names on standard
-- error.
loadFilm :: SceneOptions -> IO (Either [String] (Either Scene Film))
loadFilm options = do
  bytes <- traverse readSceneFile (sceneFile options)
  mapM_ (mapM_ (warnFormerNames options)) bytes
  pure $ case sequence bytes of
    Left line -> Left [line]
    Right contents -> do
      film <- resolveFilm options contents
      maybe (Left <$> resolveScene options contents) (Right . Right) film

-- | One line for each mistake in the scenes of some frames (in increasing order), with
-- the numbers of all frames that have it.
frameFaults :: Film -> [Int] -> [String]
frameFaults film frames =
  [ (if length wrong == 1 then "frame " else "frames ") ++ frameRanges (reverse wrong) ++ ": " ++ text
    | (text, wrong) <- sortOn (lastOf . snd) (Map.toList faults)
  ]
  where
    faults =
      Map.fromListWith
        (++)
        [ (renderProblem problem, [n])
          | n <- frames,
            Left problems <- [frameScenes film n],
            problem <- problems
        ]
    lastOf = foldl (const Just) Nothing

-- | The greatest number of such lines to print.
maximumFaults :: Int
maximumFaults = 20
