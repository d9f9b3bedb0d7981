module BlackHole.Cli.PhotonSpec (spec) where

import BlackHole.Cli.Options (Parsed (..), parseArguments)
import BlackHole.Cli.Photon.Options
import BlackHole.Cli.Photon.Report
import BlackHole.Scene.Problem
import qualified Data.ByteString.Lazy.Char8 as Lazy
import Data.List (isInfixOf, isPrefixOf)
import Data.Maybe (mapMaybe)
import Options.Applicative
import Support.Approx
import Support.Json
import Support.KerrReference (kerrRows)
import Test.Hspec
import Text.Read (readMaybe)

spec :: Spec
spec = do
  describe "--json" $ do
    it "prints the deflection of --impact 2.65 within 1e-10" $
      at ["deflection"] ["--impact", "2.65"] >>= (`shouldBeWithin` (1e-10, 3.55793804245965))
    it "has exactly these keys" $
      mapM_
        (\arguments -> fmap keys (json arguments) `shouldReturn` reportKeys)
        [["--impact", "2.65"], ["--impact", "2.5"], ["--impact", "0"], camera]
    it "is null where a captured path has no value" $ do
      captured <- json ["--impact", "2.5"]
      member "fate" captured `shouldBe` Just (Text "captured")
      member "deflection" captured `shouldBe` Just Null
      member "closestApproach" captured `shouldBe` Just Null
    it "gives each crossing its radius, azimuth and shift" $ do
      report <- json camera
      case member "crossings" report of
        Just (List [first, second]) -> do
          map keys [first, second] `shouldBe` replicate 2 ["r", "azimuth", "g"]
          mapM_
            ( \(crossing, key, reference) ->
                maybe
                  (expectationFailure key)
                  (`shouldBeWithin` (1e-8, reference))
                  (numberAt [key] crossing)
            )
            [ (first, "r", 10.27369270291),
              (first, "g", 0.94812614213424),
              (second, "azimuth", -1.57079632679)
            ]
        other -> expectationFailure (show other)
    it "follows light around a rotating hole: 34-digit values" $ do
      report <- json turning
      keys report
        `shouldBe` [ "fate",
                     "lambda",
                     "carterQ",
                     "minoTime",
                     "frequency",
                     "escapeDirection",
                     "crossings"
                   ]
      mapM_
        ( \(key, reference) ->
            maybe
              (expectationFailure key)
              (`shouldBeWithin` (1e-12, reference))
              (numberAt [key] report)
        )
        [ ("lambda", -0.015216616970296247),
          ("carterQ", 8.5489811865240428),
          ("minoTime", 1.6070728287034354),
          ("frequency", 1.0170951790080858)
        ]
      case member "crossings" report of
        Just (List [first, _]) ->
          maybe
            (expectationFailure "g")
            (`shouldBeWithin` (1e-12, 0.95444088919855479))
            (numberAt ["g"] first)
        other -> expectationFailure (show other)
    it "follows light to observers in motion: 34-digit values" $ do
      rows <- kerrRows "kerr-observers.csv"
      length rows `shouldSatisfy` (> 10)
      mapM_ observes rows
    it "has the same keys without spin as with a spin of 0" $
      fmap keys (json (camera ++ ["--spin", "0"])) `shouldReturn` reportKeys
    it "sets the leapfrog's values beside the exact ones and the errors" $ do
      report <- json (camera ++ ["--integrator", "leapfrog", "--step", "0.05"])
      keys report `shouldBe` reportKeys ++ ["exact", "error"]
      fmap keys (member "exact" report) `shouldBe` Just reportKeys
      case ( numberAt ["sweptAngle"] report,
             numberAt ["exact", "sweptAngle"] report,
             numberAt ["error", "sweptAngle"] report
           ) of
        (Just stepped, Just exact, Just difference) -> do
          difference `shouldBeWithin` (1e-14, stepped - exact)
          abs difference `shouldSatisfy` (\e -> e > 1e-8 && e < 1e-3)
        other -> expectationFailure (show other)
    it "--step is what makes the error smaller" $ do
      -- Down to the error of the report's steps beyond r = 40, which are fixed.
      errors <-
        mapM
          ( \l ->
              abs
                <$> at ["error", "deflection"] (camera ++ ["--integrator", "leapfrog", "--step", l])
          )
          ["0.16", "0.08", "0.04"]
      zipWith (/) errors (drop 1 errors) `shouldSatisfy` all (\q -> abs (q - 4) < 0.6)
  describe "the table" $ do
    it "has a row for each value, with its unit" $ do
      rows <- takeWhile (not . null) . lines <$> text camera
      map (\row -> (takeWhile (/= "") (cells row), last (words row))) rows
        `shouldSatisfy` \found ->
          [(name, unit) | (name : _, unit) <- found, unit `elem` ["r_s", "rad"]]
            == [ ("impact parameter", "r_s"),
                 ("swept angle", "rad"),
                 ("deflection", "rad"),
                 ("closest approach", "r_s")
               ]
              ++ concat
                [ [("crossing " ++ n ++ ", r", "r_s"), ("crossing " ++ n ++ ", azimuth", "rad")]
                  | n <- ["1", "2"]
                ]
      map (take 1 . cells) rows `shouldContain` [["crossing 1, g"]]
      length rows `shouldBe` 14
    it "explains r_s and, if there are crossings, g" $ do
      text camera
        >>= ( `shouldSatisfy`
                \shown ->
                  "r_s is the Schwarzschild radius" `isInfixOf` shown
                    && "g is the frequency" `isInfixOf` shown
            )
      text ["--psi", "10", "--inclination", "90"]
        >>= (`shouldSatisfy` not . isInfixOf "g is the frequency")
    it "has a column each for another method, the exact values and the errors" $
      mapM_
        ( \name -> do
            rows <- takeWhile (not . null) . lines <$> text (camera ++ ["--integrator", name])
            map words (take 1 rows) `shouldBe` [[name, "exact", "error"]]
            map (length . cells) (drop 1 rows) `shouldSatisfy` all (`elem` [4, 5])
        )
        ["leapfrog", "table"]
  describe "defaults" $ do
    it "stand in for all options but --psi" $ do
      brief <- text ["--psi", "10"]
      text
        [ "--distance",
          "30",
          "--inclination",
          "82",
          "--psi",
          "10",
          "--eta",
          "0",
          "--integrator",
          "exact"
        ]
        `shouldReturn` brief
    it "are those that the help names" $
      case parseArguments "v" ["help", "photon"] of
        Inform shown ->
          mapM_
            (\part -> unwords (words shown) `shouldSatisfy` isInfixOf part)
            [ "with --psi (default: 30)",
              "goes to (default: 82)",
              "up (default: 0)",
              "(default: exact)"
            ]
        other -> expectationFailure (show other)
  describe "--integrator table" $ do
    it "follows the path that the renderer follows, within its error" $
      mapM_
        ( \arguments -> do
            report <- json (arguments ++ ["--integrator", "table"])
            mapM_
              ( \path -> case (numberAt path report, numberAt ("exact" : path) report) of
                  (Just tabulated, Just exact) -> do
                    tabulated `shouldBeWithin` (1e-5, exact)
                    -- It is another calculation, not the same one again.
                    (path, tabulated == exact) `shouldBe` (path, False)
                  other -> expectationFailure (show (path, other))
              )
              [["sweptAngle"], ["deflection"], ["closestApproach"]]
        )
        [["--psi", "10"], camera, ["--psi", "90", "--distance", "3"]]
    it "knows light that falls in" $ do
      report <- json ["--psi", "2", "--integrator", "table"]
      member "fate" report `shouldBe` Just (Text "captured")
    it "follows light that goes straight away or straight in" $
      mapM_
        ( \psi ->
            json ["--psi", psi, "--integrator", "table"] >>= \report ->
              numberAt ["error", "sweptAngle"] report `shouldBe` Just 0
        )
        ["0", "180"]
    it "follows light around a rotating hole, within its error" $
      mapM_
        ( \arguments -> do
            report <- json (arguments ++ ["--integrator", "table"])
            case numberAt ["error", "escapeDirection"] report of
              Just missed -> missed `shouldSatisfy` (\angle -> angle > 0 && angle < 1e-6)
              Nothing -> expectationFailure "no direction"
            case member "error" report >>= member "crossings" of
              Just (List crossings@(_ : _)) ->
                mapM_
                  (maybe (pure ()) (`shouldBeWithin` (1e-5, 0)) . numberAt ["r"])
                  crossings
              other -> expectationFailure (show other)
        )
        [turning, turning ++ ["--observer", "orbiting"], turning ++ ["--observer", "falling"]]
  describe "--path" $ do
    it "leads from an observer inside the horizon to where the light comes from" $ do
      let inside =
            words "--spin 0.9 --observer falling --distance 0.6 --inclination 60 --psi 110 --eta 20"
      points <- mapMaybe (mapM readMaybe . fields) . lines . Lazy.unpack <$> csv inside
      direction <- member "escapeDirection" <$> json inside
      let places = [(x, y, z) | [_, _, x, y, z] <- points] :: [(Double, Double, Double)]
          apart (x, y, z) (x', y', z') =
            sqrt ((x - x') * (x - x') + (y - y') * (y - y') + (z - z') * (z - z'))
          size = apart (0, 0, 0)
      case (places, direction) of
        (first : _, Just (List [Number dx, Number dy, Number dz])) -> do
          apart first (0, 0.6 * cos (pi / 3), 0.6 * sin (pi / 3)) `shouldSatisfy` (< 1e-9)
          zipWith (\p q -> apart p q / size p) places (drop 1 places) `shouldSatisfy` all (< 0.1)
          let end@(x, y, z) = last places
          apart (x / size end, y / size end, z / size end) (dx, dy, dz) `shouldSatisfy` (< 0.03)
        other -> expectationFailure (show other)
    it "is a table of angles and places, from start to end" $ do
      rows <- lines . Lazy.unpack <$> csv camera
      take 1 rows `shouldBe` ["swept_angle_rad,r,x,y,z"]
      let points = mapMaybe (mapM readMaybe . fields) (drop 1 rows) :: [[Double]]
      length points `shouldBe` length rows - 1
      points `shouldSatisfy` all onItsRadius
      take 1 points `shouldSatisfy` all startsAtCamera
      length points `shouldSatisfy` (> 100)
    it "follows the leapfrog where that is asked for" $ do
      exact <- csv camera
      stepped <- csv (camera ++ ["--integrator", "leapfrog"])
      exact `shouldSatisfy` (/= stepped)
  describe "mistakes name the option, the value and the range" $ do
    refuses ["--impact=-1"] [("--impact", "-1")]
    refuses ["--impact", "nan"] [("--impact", "NaN")]
    refuses ["--impact", "inf"] [("--impact", "Infinity")]
    refuses
      []
      [ ( "--psi",
          "missing; give --psi DEGREES for a line of sight, or --impact B for light from infinity"
        )
      ]
    refuses
      ("--impact" : "3" : camera)
      [("--impact", "cannot be combined with --psi or --distance")]
    refuses
      ["--impact", "3", "--distance", "9"]
      [("--impact", "cannot be combined with --psi or --distance")]
    refuses
      ["--impact", "3", "--integrator", "table"]
      [ ( "--integrator",
          "table applies only with --psi; it holds the paths that start at the camera's distance"
        )
      ]
    refuses
      ["--distance", "1", "--inclination", "80", "--psi", "10", "--eta", "0"]
      [("--distance", "1")]
    refuses
      ["--distance", "20", "--inclination", "181", "--psi=-1", "--eta", "nan"]
      [("--psi", "-1"), ("--inclination", "181"), ("--eta", "NaN")]
    refuses
      ["--impact", "3", "--step", "0.1"]
      [("--step", "0.1 has no effect; it applies only with --integrator leapfrog")]
    refuses ["--impact", "3", "--integrator", "leapfrog", "--step", "0"] [("--step", "0")]
    refuses ["--impact", "3", "--path", ""] [("--path", "an empty name")]
    refuses ["--spin", "1", "--psi", "5"] [("--spin", "1")]
    refuses
      ["--spin", "0.9", "--impact", "3"]
      [ ( "--impact",
          "applies only without --spin, where every path lies in a plane"
        )
      ]
    refuses
      ["--spin", "0.9", "--psi", "3", "--integrator", "leapfrog"]
      [ ( "--integrator",
          "leapfrog applies only without --spin, where every path lies in a plane"
        )
      ]
    refuses
      ["--observer", "zamo", "--impact", "3"]
      [("--impact", "applies only to an observer at rest (--observer static)")]
    refuses
      (words "--spin 0.9 --psi 5 --distance 0.5 --observer zamo")
      [("--distance", "0.5")]
    refuses
      (words "--spin 0.9 --psi 5 --distance 0.75 --observer orbiting --inclination 90")
      [("--distance", "0.75")]
    refuses
      (words "--spin 0.9 --psi 5 --distance 0.5 --observer falling")
      [("--psi", "5")]
    refuses ["--spin", "0.9"] [("--psi", "missing; give --psi DEGREES for a line of sight")]
    refuses
      ["--spin", "0.9", "--psi", "5", "--distance", "0.9", "--inclination", "90"]
      [("--distance", "0.9")]
    it "in one line" $ case resolvePhoton <$> parsed ["--impact=-1"] of
      Just (Left [problem]) ->
        renderProblem problem
          `shouldSatisfy` ( \s ->
                              "--impact: -1 is not " `isPrefixOf` s && "1e6" `isInfixOf` s
                                && '\n' `notElem` s
                          )
      _ -> expectationFailure "not one problem"
  where
    turning =
      ["--spin", "0.9", "--distance", "30", "--inclination", "82", "--psi", "5.5", "--eta", "-90"]
    observes cells' = case cells' of
      observer : s : r : i : psi : eta : nu : lambda : q : fate : direction -> do
        report <-
          json
            [ "--observer=" ++ observer,
              "--spin=" ++ s,
              "--distance=" ++ r,
              "--inclination=" ++ i,
              "--psi=" ++ psi,
              "--eta=" ++ eta
            ]
        member "fate" report `shouldBe` Just (Text fate)
        mapM_
          ( \(key, known) -> case (numberAt [key] report, readMaybe known) of
              (Just found, Just reference) ->
                found `shouldBeWithin` (1e-12 * abs reference, reference)
              other -> expectationFailure (show other)
          )
          [("frequency", nu), ("lambda", lambda), ("carterQ", q)]
        case (member "escapeDirection" report, mapM readMaybe direction) of
          (Just (List found), Just reference) ->
            sequence_
              [ component `shouldBeWithin` (1e-13, known)
                | (Number component, known) <- zip found reference
              ]
          (Just Null, Nothing) -> pure ()
          other -> expectationFailure (show other)
      _ -> expectationFailure "no row"
    camera = ["--distance", "20", "--inclination", "80", "--psi", "10", "--eta", "-90"]
    reportKeys =
      [ "fate",
        "impactParameter",
        "sweptAngle",
        "deflection",
        "closestApproach",
        "crossings",
        "steps",
        "angularMomentumDrift",
        "energyDrift"
      ]
    parsed arguments =
      getParseResult (execParserPure defaultPrefs (info photonOptions mempty) arguments)
    outcome arguments = case resolvePhoton <$> parsed arguments of
      Just (Right task) -> pure (photonOutcome task)
      Just (Left problems) -> fail (concatMap renderProblem problems)
      Nothing -> fail "not parsed"
    text arguments = outcomeText False <$> outcome arguments
    csv arguments = outcomeCsv <$> outcome arguments
    json arguments = do
      printed <- outcomeText True <$> outcome arguments
      maybe (fail ("not JSON: " ++ printed)) pure (readJson printed)
    at path arguments = json arguments >>= maybe (fail "no number there") pure . numberAt path
    -- Cells of a row: parts with at least two blanks between them.
    cells row = case row of
      "" -> []
      ' ' : ' ' : rest -> "" : cells (dropWhile (== ' ') rest)
      _ -> case splitCell row of
        (cell, rest) -> cell : cells (dropWhile (== ' ') rest)
    splitCell row = case row of
      "" -> ("", "")
      ' ' : ' ' : rest -> ("", rest)
      c : rest -> let (cell, more) = splitCell rest in (c : cell, more)
    keys report = case report of
      Object members -> map fst members
      _ -> []
    refuses arguments problems =
      it (unwords ("photon" : arguments)) $
        case resolvePhoton <$> parsed arguments of
          Just (Left found) ->
            map (\p -> (problemOption p, problemValue p)) found `shouldBe` problems
          _ -> expectationFailure "taken"
    onItsRadius point = case point of
      [_, r, x, y, z] -> abs (r - sqrt (x * x + y * y + z * z)) < 1e-9 * r
      _ -> False
    startsAtCamera point = case point of
      angle : r : _ -> angle == 0 && abs (r - 20) < 1e-12
      _ -> False
    fields s = case break (== ',') s of
      (field, _ : rest) -> field : fields rest
      (field, []) -> [field]
